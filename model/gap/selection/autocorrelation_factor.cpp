#include "model/gap/selection/autocorrelation_factor.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "model/gap/noise/correlation_time.hpp"

namespace wheelwright::gap {

double autocorrelation_factor_of(const FitProblem& problem, const std::vector<double>& worse,
                                 const std::vector<double>& better) {
  constexpr double max_factor = 30.0;
  std::map<std::pair<std::size_t, std::size_t>, double> blocks;
  double power = 0.0;
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < better.size(); ++i) {
    const double change = worse[i] - better[i];
    const double period_s = problem.runs()[indices[i].run].period_s;
    const auto block =
        static_cast<std::size_t>(static_cast<double>(indices[i].period) * period_s / independent_after_s);
    blocks[{indices[i].run, block}] += better[i] * change;
    power += change * change;
  }
  if (!(power > 0.0)) return 1.0;
  double variance = 0.0;
  for (const auto& [key, sum] : blocks) variance += sum * sum;
  return std::clamp(variance / power, 1.0, max_factor);
}

double autocorrelation_factor_of_gain(const FitProblem& problem, double gain_nats,
                                      const std::vector<double>& without, const std::vector<double>& with) {
  return gain_nats < 0.0 ? autocorrelation_factor_of(problem, with, without)
                         : autocorrelation_factor_of(problem, without, with);
}

}  // namespace wheelwright::gap
