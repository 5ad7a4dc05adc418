#include "model/gap/selection/autocorrelation_factor.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "model/gap/noise/correlation_time.hpp"

namespace wheelwright::gap {

double autocorrelation_factor_of(const Problem& problem, const std::vector<double>& worse,
                                 const std::vector<double>& better) {
  constexpr double max_factor = 30.0;
  std::map<std::pair<std::size_t, std::size_t>, double> blocks;
  double power = 0.0;
  const auto& places = problem.places();
  for (std::size_t i = 0; i < better.size(); ++i) {
    const double change = worse[i] - better[i];
    const double period_s = problem.runs()[places[i].run].period_s;
    const auto block =
        static_cast<std::size_t>(static_cast<double>(places[i].period) * period_s / independent_after_s);
    blocks[{places[i].run, block}] += better[i] * change;
    power += change * change;
  }
  if (!(power > 0.0)) return 1.0;
  double variance = 0.0;
  for (const auto& [key, sum] : blocks) variance += sum * sum;
  return std::clamp(variance / power, 1.0, max_factor);
}

double autocorrelation_factor_of_gain(const Problem& problem, double gain_nats,
                                      const std::vector<double>& without, const std::vector<double>& with) {
  return gain_nats < 0.0 ? autocorrelation_factor_of(problem, with, without)
                         : autocorrelation_factor_of(problem, without, with);
}

}  // namespace wheelwright::gap
