#include "tools/wheelwright/import/conversion/wheel_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelwright::import {
namespace {

constexpr std::size_t max_rolling = 30;  // rows for which a wheel may roll on against its command

int sign_of(double value) {
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

// The row of a reversal that was asked for at `from`: the first at which the speed rises again.
std::size_t turning_row(std::span<const double> speeds, std::size_t from, std::size_t end) {
  std::size_t at = from;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = from; i < std::min(end, from + max_rolling); ++i) {
    if (!std::isfinite(speeds[i])) continue;
    if (speeds[i] <= lowest) {
      lowest = speeds[i];
      at = i;
    } else if (speeds[i] > lowest + 1.0 && speeds[i] > 1.5 * lowest) {
      break;
    }
  }
  return at;
}

// Of each row, with what is in force before it: a command acts from the row behind it on.
std::vector<int> directions(std::span<const double> speeds, std::span<const double> command) {
  std::vector<int> result(speeds.size(), 1);
  std::vector<std::size_t> reversals;
  std::vector<int> asked;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const int sign = sign_of(command[i]);
    if (sign == 0 || (!asked.empty() && asked.back() == sign)) continue;
    asked.push_back(sign);
    reversals.push_back(i);
  }
  if (asked.empty()) return result;
  int direction = asked.front();
  std::size_t at = 0;
  for (std::size_t k = 0; k <= asked.size(); ++k) {
    const bool is_last = k == asked.size();
    const std::size_t until =
        is_last  ? speeds.size()
        : k == 0 ? 0
                 : turning_row(speeds, reversals[k], k + 1 < asked.size() ? reversals[k + 1] : speeds.size());
    for (; at < until; ++at) result[at] = direction;
    if (!is_last) direction = asked[k];
  }
  return result;
}

}  // namespace

void direct_by_command(Column& values, bool are_speeds, std::span<const double> command) {
  std::vector<double> speeds(values.size(), std::numeric_limits<double>::quiet_NaN());
  double last = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    speeds[i] = are_speeds ? values[i] : std::abs(values[i] - last);
    last = values[i];
  }
  const auto direction = directions(speeds, command);
  double sum = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (are_speeds) {
      values[i] *= direction[i];
    } else {
      sum = std::isfinite(speeds[i]) ? sum + direction[i] * speeds[i] : values[i];
      values[i] = sum;
    }
  }
}

}  // namespace wheelwright::import
