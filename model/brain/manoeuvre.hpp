// One thing that the robot does: a source of commands, tick by tick.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "model/brain/mission.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright {

// What a manoeuvre asks for at a tick.
struct WheelOrder {
  WheelPair speed_m_s;
  Activity activity = Activity::idle;
  std::uint16_t repetition = 0;
};

class Manoeuvre {
 public:
  virtual ~Manoeuvre() = default;
  // Back to the beginning.
  virtual void restart() = 0;
  // The order of the next tick, or nothing once the manoeuvre is over. `latest` is the newest frame.
  virtual std::optional<WheelOrder> next(const SensorFrame& latest) = 0;
};

// Stands until no wheel has moved for a while.
std::unique_ptr<Manoeuvre> make_wait_until_still(double period_s);
// Left wheel forward and back, to see which counter is the left one.
std::unique_ptr<Manoeuvre> make_encoder_check(double period_s);
// Turns in place until the counts of the planned number of turns have passed, counter-clockwise and then
// back.
std::unique_ptr<Manoeuvre> make_encoder_turn(const EncoderTurnPlan& plan, double period_s);
// Left on, left off, right on, right off, as often as planned; each off lasts until the robot stands.
std::unique_ptr<Manoeuvre> make_response_actions(const ResponsePlan& plan, double period_s);
// Gives commands from the tick that is nearest to their time on, at any period; the one that reads no sensor.
std::unique_ptr<Manoeuvre> make_commanded_drive(CommandedDrive drive, double period_s);

}  // namespace wheelwright
