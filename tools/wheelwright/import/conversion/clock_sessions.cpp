#include "tools/wheelwright/import/conversion/clock_sessions.hpp"

#include <algorithm>
#include <cmath>

#include "tools/wheelwright/import/conversion/time_repair.hpp"

namespace wheelwright::import {

std::vector<SessionRows> clock_sessions(std::span<const double> t_s) {
  constexpr double late_s = 1.0;
  constexpr double late_steps = 6.0;
  const double back_s = std::max(late_s, late_steps * median_step_s(t_s));
  std::vector<SessionRows> sessions;
  double latest_s = 0.0;
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    if (!std::isfinite(t_s[row])) continue;
    if (sessions.empty() || t_s[row] < latest_s - back_s) {
      sessions.emplace_back();
      latest_s = t_s[row];
    }
    sessions.back().push_back(row);
    latest_s = std::max(latest_s, t_s[row]);
  }
  for (SessionRows& rows : sessions)
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return t_s[row]; });
  return sessions;
}

}  // namespace wheelwright::import
