// Metres per encoder tick from turning in place (calibration A and eq. 13 of the source paper).
//
// While the robot turns, its six light-bumper sensors sweep over the surroundings. Plotted over encoder ticks
// instead of time the signals are periodic, whatever the speed does; one period is one full turn, in which
// each wheel travels pi times the wheel base.
//
//   autocorrelation  any surroundings: the lag at which all six signals match themselves best
//   peak             one obstacle: the distance between its passes
//
// The robot turns one way and back. Where it drifts while it turns (on a slope it gets a little downhill in
// each turn), the bearing of what it sees shifts from turn to turn; turning one way this makes a turn look
// longer, the other way shorter by about as much, and the mean of both is nearly right. Tyres that scrub make
// a turn longer both ways; turning alone cannot show that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "model/geometry/pose.hpp"
#include "model/identification/refusal.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright {

// One sample of the turn.
struct TurnSample {
  WheelTicks ticks;  // unwrapped
  LightBumper light_bumper{};
};

enum class PeriodMethod : std::uint8_t { autocorrelation, peak };

struct EncoderScaleOptions {
  PeriodMethod method = PeriodMethod::autocorrelation;
  double wheel_base_m = 0.235;
  // Ticks of one wheel in one turn that are plausible for this kind of robot; a room that looks the same
  // every quarter turn is told from a full one by them. 1660 for a Roomba's geometry.
  double expected_ticks_per_turn = 1660.0;
  double expected_tolerance = 0.2;        // relative
  double largest_standard_error = 0.005;  // relative; a result less certain than this is refused
};

// The match of the signals with themselves over the lag, for the report.
struct CorrelationPoint {
  double lag_ticks = 0.0;
  double correlation = 0.0;
};

struct EncoderScaleFit {
  WheelPair metres_per_tick;    // alike: a turn in place does not tell the wheels apart
  double ticks_per_turn = 0.0;  // mean of both wheels
  // Of metres per tick: from the spread between parts of the turn, and a share of the drift.
  double relative_standard_error = 0.0;
  double correlation = 0.0;  // at the period found; 1 is a perfect repetition
  double turns = 0.0;        // how many were recorded, both ways
  // Half the difference between counter-clockwise and clockwise, relative to the mean; nothing where the
  // robot turned one way only.
  std::optional<double> drift;
  std::vector<CorrelationPoint> curve;
};

// Refuses, with the reason, where the signal has no clear period or too little was recorded.
tl::expected<EncoderScaleFit, Refusal> fit_encoder_scale(std::span<const TurnSample> samples,
                                                         const EncoderScaleOptions& options);

}  // namespace wheelwright
