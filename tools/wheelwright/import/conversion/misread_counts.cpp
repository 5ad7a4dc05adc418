#include "tools/wheelwright/import/conversion/misread_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr std::array misread_values{0.0,      -1.0,         255.0,        65535.0,      32767.0,
                                    -32768.0, 4294967295.0, 2147483647.0, -2147483648.0};
constexpr double jump_steps = 10.0;
constexpr std::size_t longest_stretch = 20;  // rows

bool may_be_misread(double count) {
  return std::ranges::find(misread_values, count) != misread_values.end();
}

// Percentile 75 of the sizes of the steps that are any: up to a tenth of the rows may be misread.
double large_step_of(std::span<const double> counts) {
  constexpr std::size_t min_steps = 20;
  std::vector<double> steps;
  for (std::size_t i = 1; i < counts.size(); ++i) {
    const double step = std::abs(counts[i] - counts[i - 1]);
    if (step > 0.0 && std::isfinite(step)) steps.push_back(step);
  }
  return steps.size() < min_steps ? 0.0 : quantile(std::move(steps), 0.75);
}

// Of counters of fewer bits, the number at which it starts again: it comes near that, and never above.
double modulus_of(std::span<const double> counts) {
  constexpr double near_end = 0.9;
  double highest = 0.0;
  for (const double count : counts) {
    if (std::isfinite(count) && (!may_be_misread(count) || count == 255.0))
      highest = std::max(highest, count);
  }
  for (const double modulus : {256.0, 1024.0, 4096.0, 16384.0}) {
    if (highest < modulus) return highest >= near_end * modulus ? modulus : 0.0;
  }
  return 0.0;
}

// The way from one count to another, the short way round a counter of 16 or 32 bits, or of so many numbers.
double shortest_step(double from, double to, double other_modulus) {
  double shortest = std::abs(to - from);
  for (const double modulus : {65536.0, 4294967296.0, other_modulus}) {
    if (modulus > 0.0) shortest = std::min(shortest, std::abs(std::remainder(to - from, modulus)));
  }
  return shortest;
}

}  // namespace

std::vector<std::size_t> misread_counts(std::span<const double> counts) {
  std::vector<std::size_t> misread;
  if (std::ranges::none_of(counts, may_be_misread)) return misread;
  const double step = large_step_of(counts);
  const double modulus = modulus_of(counts);
  if (!(step > 0.0)) return misread;
  for (std::size_t i = 1; i + 1 < counts.size(); ++i) {
    const double before = counts[i - 1];
    if (!may_be_misread(counts[i]) || !(shortest_step(before, counts[i], modulus) > jump_steps * step))
      continue;
    std::size_t end = i + 1;
    while (end < counts.size() && counts[end] == counts[i]) ++end;
    const std::size_t rows = end - i;
    const bool goes_on =
        end < counts.size() && rows <= longest_stretch &&
        shortest_step(before, counts[end], modulus) <= 2.0 * step * static_cast<double>(rows + 1);
    if (goes_on) {
      for (std::size_t row = i; row < end; ++row) misread.push_back(row);
    }
    i = end - 1;
  }
  return misread;
}

void leave_out_misread_counts(DriveColumns& columns, const WheelMapping& wheels) {
  const bool are_counted =
      !wheels.per_row && (wheels.kind == WheelKind::counts || wheels.kind == WheelKind::distance);
  for (std::size_t side = 0; are_counted && side < 2; ++side) {
    Column& counts = columns.wheel[side];
    if (is_log_on_change(counts)) continue;
    const auto rows = misread_counts(counts);
    if (rows.empty()) continue;
    columns.has_misread_counts = true;
    columns.remarks.push_back(columns.place(rows.front()) + ": the " + (side == 0 ? "left" : "right") +
                              " counter reads " + config::plain_number(counts[rows.front()]) + " (" +
                              std::to_string(rows.size()) +
                              " such rows) and goes on where it was: not read, the counts of these rows are "
                              "left out");
    for (const std::size_t row : rows) counts[row] = nothing;
  }
}

}  // namespace wheelwright::import
