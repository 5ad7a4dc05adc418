#include "tools/wheelwright/import/inference/mirrored_side.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
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
  double right_is_mirrored = 0.0;  // above 0 where the right wheel is, and not the left one

  void add_turn(double turn, double left, double right) {
    as_read.add(std::abs(right - left), std::abs(turn));
    mirrored.add(std::abs(right + left), std::abs(turn));
    right_is_mirrored -= turn * (left + right);
  }
};

// A heading starts again behind a turn if it stays within one.
double turn_between(const Column& theta_rad, std::size_t from, std::size_t to, bool stays_within_a_turn) {
  const double turn = theta_rad[to] - theta_rad[from];
  return stays_within_a_turn ? std::remainder(turn, 2.0 * std::numbers::pi) : turn;
}

// By headings alone, which grow counter-clockwise.
void add_headings(const DriveColumns& columns, std::span<const std::size_t> rows, const WheelTravel& travel,
                  Motion& motion) {
  constexpr double a_turn = 1.01 * 2.0 * std::numbers::pi;
  const bool stays_within_a_turn = range_of(columns.theta_rad).size() < a_turn;
  std::vector<char> is_known;
  is_known.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    is_known.push_back(
        std::isfinite(columns.theta_rad[rows[i]] + travel.values[0][i] + travel.values[1][i]) ? 1 : 0);
  for (const auto& [from, to] : windows_of(columns, rows, is_known)) {
    const double turn = turn_between(columns.theta_rad, rows[from], rows[to], stays_within_a_turn);
    motion.add_turn(turn, travel.values[0][to] - travel.values[0][from],
                    travel.values[1][to] - travel.values[1][from]);
  }
}

// By the gyro, likewise; of a robot whose wheels stand it shows its offset.
void add_turn_rates(const DriveColumns& columns, std::span<const std::size_t> rows, const WheelTravel& travel,
                    Motion& motion) {
  std::vector<char> is_known;
  Column turn(rows.size(), 0.0);
  Column resting;
  is_known.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double rate = columns.gyro[rows[i]];
    is_known.push_back(std::isfinite(rate + travel.values[0][i] + travel.values[1][i]) ? 1 : 0);
    const bool rests = i > 0 && travel.values[0][i] == travel.values[0][i - 1] &&
                       travel.values[1][i] == travel.values[1][i - 1];
    if (rests && std::isfinite(rate)) resting.push_back(rate);
  }
  constexpr std::size_t enough_rows = 20;
  const double offset = resting.size() >= enough_rows ? median(std::move(resting)) : 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double rate = columns.gyro[rows[i]] - offset;
    turn[i] =
        turn[i - 1] + (std::isfinite(rate) ? rate * (columns.t_s[rows[i]] - columns.t_s[rows[i - 1]]) : 0.0);
  }
  for (const auto& [from, to] : windows_of(columns, rows, is_known))
    motion.add_turn(turn[to] - turn[from], travel.values[0][to] - travel.values[0][from],
                    travel.values[1][to] - travel.values[1][from]);
}

void add_places(const DriveColumns& columns, std::span<const std::size_t> rows, const WheelTravel& travel,
                Motion& motion) {
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
    motion.right_is_mirrored += (std::cos(heading) * x + std::sin(heading) * y) * (left - right);
  }
}

}  // namespace

bool infer_mirrored_side(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings) {
  const bool has_signs = mapping.command && !mapping.command->is_of_body() && !columns.command[1].empty() &&
                         mapping.wheels && !mapping.wheels->left_reversed &&
                         !mapping.wheels->right_reversed && !mapping.command->left_reversed &&
                         !mapping.command->right_reversed;
  const bool has_places = !columns.x.empty() && !columns.y.empty();
  if (!has_signs || given.says("wheels.reversed") || given.says("command.reversed") ||
      (!has_places && columns.theta_rad.empty() && columns.gyro.empty()) ||
      !has_turning_wheels(columns, mapping))
    return false;
  Motion motion;
  for (const auto& rows : repair_runs(columns, mapping).runs) {
    const WheelTravel travel = wheel_travel(columns, rows, mapping);
    has_places                   ? add_places(columns, rows, travel, motion)
    : !columns.theta_rad.empty() ? add_headings(columns, rows, travel, motion)
                                 : add_turn_rates(columns, rows, travel, motion);
  }
  if (!motion.mirrored.holds() || motion.mirrored.correlation() < min_agreement ||
      motion.as_read.correlation() > max_agreement_as_read)
    return false;
  const bool is_right = motion.right_is_mirrored >= 0.0;
  const auto rows = response_rows(columns, mapping);
  // An encoder alone that counts backwards contradicts its command, and is a doubt.
  if (!(fit_response(rows[is_right ? 1 : 0]).gain > 0.0)) return false;
  (is_right ? mapping.wheels->right_reversed : mapping.wheels->left_reversed) = true;
  (is_right ? mapping.command->right_reversed : mapping.command->left_reversed) = true;
  const std::string side = is_right ? "right" : "left";
  findings.push_back(
      "the " + side + " motor is mounted the other way round: with its signs turned the wheels " +
      (has_places ? "go as far as the reference" : "turn as the robot does") + " (correlation " +
      config::fixed_number(motion.mirrored.correlation(), 2) + "), as they stand they do not (" +
      config::fixed_number(motion.as_read.correlation(), 2) + ")");
  return true;
}

void doubt_mirrored_side(const DriveColumns& columns, const Mapping& mapping,
                         std::vector<std::string>& doubts) {
  constexpr double turning_by_going = 2.0;
  if (!mapping.command || mapping.command->is_of_body() || mapping.reference || columns.command[1].empty() ||
      mapping.command->left_reversed || mapping.command->right_reversed)
    return;
  double turning = 0.0;
  double going = 0.0;
  for (std::size_t row = 0; row < columns.rows(); ++row) {
    const double left = columns.command[0][row];
    const double right = columns.command[1][row];
    if (!std::isfinite(left + right)) continue;
    turning += std::abs(right - left);
    going += std::abs(right + left);
  }
  if (turning <= turning_by_going * going) return;
  doubts.emplace_back(
      "the wheels are sent opposite ways most of the time, so that the robot would turn on the spot; if one "
      "motor is mounted the other way round: --set command.reversed=right --set wheels.reversed=right");
}

}  // namespace wheelwright::import
