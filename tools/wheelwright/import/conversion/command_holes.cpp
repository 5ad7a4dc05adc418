#include "tools/wheelwright/import/conversion/command_holes.hpp"

#include <algorithm>
#include <cmath>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_commands = 20;
constexpr double min_hole_s = 1.0;
constexpr double min_hole_steps = 20.0;
constexpr double steady_share = 0.9;  // of the steps that are no longer than twice the usual one

bool is_steady(const std::vector<double>& steps_s, double usual_s) {
  const auto even = std::ranges::count_if(steps_s, [usual_s](double step) { return step < 2.0 * usual_s; });
  return static_cast<double>(even) >= steady_share * static_cast<double>(steps_s.size());
}

}  // namespace

std::vector<CommandHole> command_holes(const DriveColumns& columns, const std::vector<std::size_t>& rows,
                                       const std::vector<double>& t_s) {
  const auto says = [&](std::size_t i, std::size_t side) {
    return !columns.command[side].empty() && std::isfinite(columns.command[side][rows[i]]);
  };
  std::vector<std::size_t> said;
  std::vector<double> steps_s;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!says(i, 0) && !says(i, 1)) continue;
    if (!said.empty()) steps_s.push_back(t_s[i] - t_s[said.back()]);
    said.push_back(i);
  }
  if (said.size() < min_commands) return {};
  const double usual_s = median(std::vector<double>(steps_s));
  if (!is_steady(steps_s, usual_s)) return {};
  std::vector<CommandHole> holes;
  for (std::size_t k = 0; k < said.size(); ++k) {
    const std::size_t next = k + 1 < said.size() ? said[k + 1] : rows.size() - 1;
    if (next < said[k] + 2) continue;  // the rows are missing, too
    const double duration_s = t_s[next] - t_s[said[k]];
    const bool drives = std::ranges::any_of(columns.command, [&](const Column& command) {
      return !command.empty() && std::isfinite(command[rows[said[k]]]) && command[rows[said[k]]] != 0.0;
    });
    if (drives && duration_s > std::max(min_hole_s, min_hole_steps * usual_s))
      holes.push_back({said[k], duration_s});
  }
  return holes;
}

}  // namespace wheelwright::import
