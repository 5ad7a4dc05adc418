#include "model/identification/fit_checks.hpp"

#include <cmath>

#include "model/identification/excitation.hpp"
#include "model/log/near_periods.hpp"

namespace wheelwright {
namespace {

std::optional<Refusal> find_no_number(const DriveLog& log) {
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const DriveSample& sample = log.samples[k];
    const double sum = sample.t_s + sample.command_m_s.left + sample.command_m_s.right;
    if (std::isfinite(sum)) continue;
    return Refusal{log.name + ": the time or a command of row " + std::to_string(k + 1) +
                   " is not a number; delete the row, its neighbours then show it as a gap"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> find_unfit_log(std::span<const DriveLog> logs) {
  if (logs.empty()) return Refusal{"no run was given"};
  for (const auto& log : logs) {
    if (!log.has_ticks()) {
      return Refusal{log.name +
                     ": has no encoder counts on its first row; a fit of wheel speeds needs ticks"};
    }
    if (std::abs(log.wheel_base_m - logs.front().wheel_base_m) > 1e-9) {
      return Refusal{log.name + ": its wheel base differs from that of " + logs.front().name +
                     "; fit runs of one robot together"};
    }
    if (auto refusal = find_no_number(log)) return refusal;
  }
  if (const auto far = find_far_period(logs)) return Refusal{*far};
  return find_missing_excitation(logs);
}

}  // namespace wheelwright
