#include "model/log/near_periods.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace wheelwright {

bool are_near_periods(double one_s, double other_s) {
  constexpr double min_delay_s = 0.005;
  constexpr double min_delay_periods = 0.25;
  const double waits_longer_s = 0.5 * std::abs(one_s - other_s);
  return waits_longer_s <= std::max(min_delay_s, min_delay_periods * std::min(one_s, other_s));
}

std::string different_periods(double period_s, const std::string& other, double other_s) {
  std::ostringstream text;
  text << "its period is " << std::setprecision(4) << period_s << " s, but that of " << other << " is "
       << other_s << " s";
  return text.str();
}

double shortest_period_s(std::span<const DriveLog> logs) {
  return std::ranges::min_element(logs, {}, &DriveLog::period_s)->period_s;
}

std::optional<std::string> find_far_period(std::span<const DriveLog> logs) {
  const DriveLog& shortest = *std::ranges::min_element(logs, {}, &DriveLog::period_s);
  for (const DriveLog& log : logs) {
    if (are_near_periods(log.period_s, shortest.period_s)) continue;
    return log.name + ":" + std::to_string(log.first_line) + ": " +
           different_periods(log.period_s, shortest.name, shortest.period_s) +
           "; commands wait so much longer that the delay is another one: use runs of one period";
  }
  return std::nullopt;
}

}  // namespace wheelwright
