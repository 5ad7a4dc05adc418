#include "model/gap/noise/steadiness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelwright::gap {

std::vector<double> unsteady_periods(std::span<const WheelPair> commands_m_s, double period_s) {
  double largest_m_s = 0.0;
  for (const WheelPair& command : commands_m_s)
    largest_m_s = std::max({largest_m_s, std::abs(command.left), std::abs(command.right)});
  const double change_m_s = steady_change * largest_m_s;
  const auto window = static_cast<std::size_t>(std::ceil(steady_after_s / period_s));
  std::vector<double> unsteady(commands_m_s.size(), 0.0);
  for (std::size_t k = 0; k < commands_m_s.size(); ++k) {
    const WheelPair& now = commands_m_s[k];
    const auto differs = [&](const WheelPair& other) {
      return std::abs(other.left - now.left) > change_m_s || std::abs(other.right - now.right) > change_m_s;
    };
    const auto before = commands_m_s.subspan(k < window ? 0 : k - window, std::min(k, window));
    const bool from_rest = k < window && differs({});
    if (from_rest || std::ranges::any_of(before, differs)) unsteady[k] = 1.0;
  }
  return unsteady;
}

std::vector<double> unsteady_shares(std::span<const double> unsteady_periods, std::span<const double> times_s,
                                    double period_s) {
  std::vector<double> shares(times_s.size(), 0.0);
  if (unsteady_periods.empty()) return shares;
  const auto period_of = [&](double time_s) {
    const double period = std::max(0.0, std::floor(time_s / period_s + 1e-6));
    return std::min(static_cast<std::size_t>(period), unsteady_periods.size() - 1);
  };
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const std::size_t first = period_of(times_s[i - 1]);
    const std::size_t last = std::max(period_of(times_s[i]), first + 1);
    double sum = 0.0;
    for (std::size_t k = first; k < last; ++k)
      sum += unsteady_periods[std::min(k, unsteady_periods.size() - 1)];
    shares[i] = sum / static_cast<double>(last - first);
  }
  return shares;
}

}  // namespace wheelwright::gap
