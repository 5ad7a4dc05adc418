#include "model/identification/free_run_starts.hpp"

#include <cmath>

#include "model/identification/arma_accumulator.hpp"
#include "model/identification/least_squares_solution.hpp"
#include "model/log/run_periods.hpp"

namespace wheelwright {

LinearModel reduce_to_arma(const LinearModel& fir, std::span<const DriveLog> logs, const ArmaLayout& layout) {
  ArmaAccumulator accumulator(layout);
  LinearPredictor predictor(fir);
  for (const auto& log : logs) {
    accumulator.start_from_rest();
    predictor.reset();
    for_each_period(log, fir.period_s, [&](const RunPeriod& period) {
      accumulator.add(period.command_m_s, predictor.step(period.command_m_s));
    });
  }
  return {ModelType::arma, fir.period_s, fir.wheel_base_m,
          layout.to_response(solve_small(accumulator.left_factor()).unknowns),
          layout.to_response(solve_small(accumulator.right_factor()).unknowns)};
}

WheelResponse drawn_to_stability(WheelResponse response) {
  constexpr double wanted_pole = 0.9;
  const double pole = largest_pole(response);
  if (pole <= wanted_pole) return response;
  // Weight i times s^(i+1) multiplies every root of the recursion by s.
  double factor = 1.0;
  for (double& weight : response.from_own_past) weight *= factor *= wanted_pole / pole;
  return response;
}

}  // namespace wheelwright
