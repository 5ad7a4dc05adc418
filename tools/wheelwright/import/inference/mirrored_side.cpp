#include "tools/wheelwright/import/inference/mirrored_side.hpp"

#include <array>
#include <cmath>
#include <span>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/robot_ways.hpp"
#include "tools/wheelwright/import/inference/turning_sense.hpp"

namespace wheelwright::import {
namespace {

constexpr double min_agreement = 0.95;
constexpr double max_agreement_as_read = 0.85;

struct Motion {
  Agreement as_read;
  Agreement mirrored;
  double forward = 0.0;  // ways along the heading times those of the left wheel, as the right one is mirrored
};

void add_run(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
             Motion& motion) {
  const WheelTravel travel = wheel_travel(columns, rows, mapping);
  std::vector<char> is_known;
  for (std::size_t i = 0; i < rows.size(); ++i)
    is_known.push_back(
        std::isfinite(columns.x[rows[i]] + columns.y[rows[i]] + travel.values[0][i] + travel.values[1][i])
            ? 1
            : 0);
  for (const auto& [from, to] : windows_of(columns, rows, is_known)) {
    const double x = columns.x[rows[to]] - columns.x[rows[from]];
    const double y = columns.y[rows[to]] - columns.y[rows[from]];
    const double left = travel.values[0][to] - travel.values[0][from];
    const double right = travel.values[1][to] - travel.values[1][from];
    motion.as_read.add(std::abs(left + right), std::hypot(x, y));
    motion.mirrored.add(std::abs(left - right), std::hypot(x, y));
    if (columns.theta_rad.empty() || !std::isfinite(columns.theta_rad[rows[from]])) continue;
    const double heading = columns.theta_rad[rows[from]];
    motion.forward += (std::cos(heading) * x + std::sin(heading) * y) * (left - right);
  }
}

}  // namespace

bool infer_mirrored_side(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings) {
  const bool has_signs = mapping.command && !mapping.command->is_of_body() && !columns.command[1].empty() &&
                         mapping.wheels && !mapping.wheels->left_reversed &&
                         !mapping.wheels->right_reversed && !mapping.command->left_reversed &&
                         !mapping.command->right_reversed;
  if (!has_signs || given.says("wheels.reversed") || given.says("command.reversed") || columns.x.empty() ||
      columns.y.empty() || !has_turning_wheels(columns, mapping))
    return false;
  Motion motion;
  for (const auto& rows : repair_runs(columns, mapping).runs) add_run(columns, rows, mapping, motion);
  if (!motion.mirrored.holds() || motion.mirrored.correlation() < min_agreement ||
      motion.as_read.correlation() > max_agreement_as_read)
    return false;
  const bool is_right = motion.forward >= 0.0;
  const auto rows = response_rows(columns, mapping);
  // An encoder alone that counts backwards contradicts its command, and is a doubt.
  if (!(fit_response(rows[is_right ? 1 : 0]).gain > 0.0)) return false;
  (is_right ? mapping.wheels->right_reversed : mapping.wheels->left_reversed) = true;
  (is_right ? mapping.command->right_reversed : mapping.command->left_reversed) = true;
  const std::string side = is_right ? "right" : "left";
  findings.push_back("the " + side +
                     " motor is mounted the other way round: with its signs turned the wheels go as far as "
                     "the reference (correlation " +
                     config::fixed_number(motion.mirrored.correlation(), 2) +
                     "), as they stand they do not (" +
                     config::fixed_number(motion.as_read.correlation(), 2) + ")");
  return true;
}

}  // namespace wheelwright::import
