#include "tools/wheelwright/import/inference/quaternion_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace wheelwright::import {
namespace {

constexpr double max_off_one = 0.01;
constexpr double max_tilt = 0.1;  // of x and y together, as a mean square
constexpr std::size_t min_quaternion_rows = 20;

double mean_square(const Channel& channel) {
  double squares = 0.0;
  double count = 0.0;
  for (const double value : channel.values) {
    if (!std::isfinite(value)) continue;
    squares += value * value;
    count += 1.0;
  }
  return count > 0.0 ? squares / count : 0.0;
}

// Of a tracker that has lost the robot, all four are 0 or another number.
bool is_lost(std::span<const Channel> four, std::size_t row) {
  return std::ranges::all_of(
      four, [&](const Channel& channel) { return channel.values[row] == four[0].values[row]; });
}

// All rows that have the four have length one, and the four are no constants.
bool is_unit(std::span<const Channel> four) {
  std::size_t rows = 0;
  double turned = 0.0;
  double first[4] = {};
  for (std::size_t i = 0; i < four[0].values.size(); ++i) {
    double squares = 0.0;
    for (const Channel& channel : four) squares += channel.values[i] * channel.values[i];
    if (!std::isfinite(squares) || is_lost(four, i)) continue;
    if (std::abs(squares - 1.0) > max_off_one) return false;
    for (std::size_t k = 0; k < four.size(); ++k) {
      if (rows == 0) first[k] = four[k].values[i];
      turned = std::max(turned, std::abs(four[k].values[i] - first[k]));
    }
    ++rows;
  }
  return rows >= min_quaternion_rows && turned > max_off_one;
}

std::vector<double> heading_of(const QuaternionColumns& parts) {
  std::vector<double> heading_rad;
  for (std::size_t i = 0; i < parts.w->values.size(); ++i) {
    const double x = parts.x->values[i], y = parts.y->values[i], z = parts.z->values[i],
                 w = parts.w->values[i];
    heading_rad.push_back(std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z));
  }
  return heading_rad;
}

}  // namespace

bool has_real_part_first(std::span<const Channel, 4> four) {
  return mean_square(four[1]) + mean_square(four[2]) < max_tilt &&
         mean_square(four[0]) + mean_square(four[1]) > max_tilt;
}

std::optional<QuaternionColumns> find_quaternion(const Stream& stream,
                                                 const std::vector<const Channel*>& unused) {
  const std::span<const Channel> channels(stream.channels);
  for (std::size_t first = 0; first + 4 <= channels.size(); ++first) {
    const auto four = channels.subspan(first, 4);
    const bool are_free = std::ranges::all_of(four, [&unused](const Channel& channel) {
      return std::ranges::find(unused, &channel) != unused.end();
    });
    if (!are_free || !is_unit(four)) continue;
    const bool real_last = mean_square(four[0]) + mean_square(four[1]) < max_tilt;
    const bool real_first = mean_square(four[1]) + mean_square(four[2]) < max_tilt;
    if (!real_last && !real_first) continue;
    QuaternionColumns found = real_last ? QuaternionColumns{&four[0], &four[1], &four[2], &four[3], {}}
                                        : QuaternionColumns{&four[1], &four[2], &four[3], &four[0], {}};
    found.heading_rad = heading_of(found);
    return found;
  }
  return std::nullopt;
}

}  // namespace wheelwright::import
