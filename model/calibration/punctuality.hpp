// Whether the machine was in time while a calibration drove by time: a command that goes out late acts late,
// and a reading that comes late is of a later moment than the model takes it for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/geometry/pose.hpp"
#include "model/identification/refusal.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright {

class Punctuality {
 public:
  explicit Punctuality(double period_s);

  // Later than half a period: not to be used as if it were in time.
  bool is_late(const SensorFrame& frame) const;

  void begin_manoeuvre();
  void take(const SensorFrame& frame);

  // Where too much came late for the rest to be believed.
  std::optional<Refusal> doubt() const;
  // How many readings were left out, where there were any.
  std::optional<std::string> remark() const;
  // Of each wheel's gain, standard deviation: from commands that began and ended unequally late, over the
  // time that they were in force.
  WheelPair relative_gain_error() const;

 private:
  struct TimingErrors {
    double squares = 0.0;
    int actions = 0;
    double relative_error() const;
  };

  double lateness_s(const SensorFrame& frame) const;
  void end_action(const SensorFrame& frame);

  double period_s_;
  int readings_ = 0;
  int late_ = 0;
  double latest_s_ = 0.0;
  WheelPair command_m_s_;        // in force
  std::int64_t since_tick_ = 0;  // when it came into force
  double began_late_by_s_ = 0.0;
  TimingErrors left_;
  TimingErrors right_;
};

}  // namespace wheelwright
