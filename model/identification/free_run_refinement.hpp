// Output-error refinement of an ARX model: the weights with which the model's free run, fed with commands
// alone, agrees best with measured wheel travel.
//
// The residual is travel at the readings' real times, undifferenced: noise there is one rounding per reading
// instead of the difference of two over 15-18 ms. It is whitened (travel_whitener.hpp: rounding, slip, drift
// that fades) with the noise found by likelihood on the way, so that the estimate is that of maximum
// likelihood. Levenberg-Marquardt steps; steps to an unstable model are never taken. Sensitivities are exact:
// with A the recursion, the derivative of y(k) with respect to the weight of u(k-i) is the command filtered
// by 1/A, i periods ago, and to the weight of y(k-i) the free run itself filtered by 1/A, i periods ago
// (Ljung, System Identification, 2nd ed., section 10.3). So three filtered signals hold them all.
//
// Ticks show little of what happens within a few periods, and a free fit of order 9 fills that with ringing
// that the data neither ask for nor forbid (poles on the unit circle beside zeros). So responses have a
// prior: they are smooth and fade, as the FIR fit of the same data has found likeliest. With exact data the
// prior has no effect.
#pragma once

#include <optional>
#include <span>

#include "model/geometry/sensor_period.hpp"
#include "model/geometry/wheel_side.hpp"
#include "model/identification/arma_layout.hpp"
#include "model/identification/least_squares_solution.hpp"
#include "model/identification/response_prior.hpp"
#include "model/identification/travel_runs.hpp"
#include "model/identification/travel_whitener.hpp"

namespace wheelwright {

// A pole beyond this is no wheel's: it would remember a command for a thousand periods.
inline constexpr double largest_allowed_pole = 0.999;

struct RefinedResponse {
  WheelResponse response;
  SmallSolution last_step;      // of the linearised problem, for the covariance of the weights
  double noise_variance = 0.0;  // m^2, of the white part of a reading
  RelativeTravelNoise noise;
  double objective = 0.0;  // negative log-likelihood of data and prior, without constants
};

struct FreeRunProblem {
  std::span<const TravelRun> runs;
  double period_s = default_period_s;
  double tick_m = 0.00044;  // rounding below which nothing is seen
  WheelSide side = WheelSide::left;
  ArmaLayout layout;
  std::optional<ResponsePrior> prior = std::nullopt;  // of the impulse responses
};

// Refines one wheel from a start whose largest pole is below largest_allowed_pole.
RefinedResponse refine_free_run(const FreeRunProblem& problem, const WheelResponse& start);

}  // namespace wheelwright
