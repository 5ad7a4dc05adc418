#include "model/gap/adequacy/variance_ratio.hpp"

#include <algorithm>

#include "model/gap/noise/correlation_time.hpp"

namespace wheelwright::gap {

double variance_ratio(const FitProblem& problem, std::span<const double> innovations) {
  double sum_squares = 0.0;
  double all = 0.0;
  double sum = 0.0;
  std::size_t block = 0;
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double time_s = problem.runs()[indices[i].run].period_s * static_cast<double>(indices[i].period);
    const auto at = static_cast<std::size_t>(time_s / independent_after_s);
    const bool same =
        i > 0 && indices[i].run == indices[i - 1].run && indices[i].channel == indices[i - 1].channel;
    if (!same || at != block) {
      sum_squares += sum * sum;
      sum = 0.0;
    }
    block = at;
    sum += innovations[i];
    all += innovations[i] * innovations[i];
  }
  return all > 0.0 ? std::max(1.0, (sum_squares + sum * sum) / all) : 1.0;
}

}  // namespace wheelwright::gap
