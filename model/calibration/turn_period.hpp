// How many ticks of turning make one full turn, from a stretch in which the robot turns one way.
#pragma once

#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "model/calibration/encoder_scale_fit.hpp"
#include "model/identification/refusal.hpp"

namespace wheelwright {

struct TurnPeriod {
  double ticks = 0.0;                    // of one full turn; half the difference of both wheels
  double relative_standard_error = 0.0;  // from the spread between parts of the stretch
  double correlation = 0.0;
  double turns = 0.0;
  std::vector<CorrelationPoint> curve;
};

// Refuses, with the reason, where the signal has no clear period or too little was recorded.
tl::expected<TurnPeriod, Refusal> fit_turn_period(std::span<const TurnSample> samples,
                                                  const EncoderScaleOptions& options);

}  // namespace wheelwright
