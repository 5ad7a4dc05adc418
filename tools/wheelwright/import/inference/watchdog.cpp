#include "tools/wheelwright/import/inference/watchdog.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/command_holes.hpp"
#include "tools/wheelwright/import/conversion/command_timeout.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"

namespace wheelwright::import {
namespace {

bool has_holes(const DriveColumns& columns, const Mapping& mapping) {
  const TimeRepair time = repair_runs(columns, mapping);
  return std::ranges::any_of(time.runs, [&](const RunRows& rows) {
    std::vector<double> t_s;
    t_s.reserve(rows.size());
    for (const std::size_t row : rows) t_s.push_back(time.t_s[row]);
    return !command_holes(columns, rows, t_s).empty();
  });
}

double nats_of(const DriveColumns& columns, const Mapping& mapping) {
  const auto rows = response_rows(columns, mapping);
  return fit_response(rows[0]).nats + fit_response(rows[1]).nats;
}

double nats_with_timeout(DriveColumns columns, const Mapping& mapping, double timeout_s) {
  stop_after_timeout(columns, timeout_s);
  return nats_of(columns, mapping);
}

}  // namespace

void infer_watchdog(DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings) {
  constexpr double sure_nats = 50.0;
  constexpr std::array chosen_s{0.1, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.75, 0.8, 1.0, 1.5, 2.0, 3.0};
  if (!mapping.command || !mapping.wheels || given.says("command.timeout_s") || !has_holes(columns, mapping))
    return;
  double most = nats_of(columns, mapping) + sure_nats;
  std::optional<double> best_s;
  for (const double timeout_s : chosen_s) {
    const double nats = nats_with_timeout(columns, mapping, timeout_s);
    if (nats <= most) continue;
    most = nats;
    best_s = timeout_s;
  }
  if (!best_s) return;
  mapping.command->timeout_s = best_s;
  stop_after_timeout(columns, *best_s);
  findings.push_back("the robot stops " + config::plain_number(*best_s) +
                     " s after the last command, where no other comes, as its wheels show; --set "
                     "command.timeout_s if you know it");
}

}  // namespace wheelwright::import
