#include "model/log/sign_corrected_travel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace wheelwright {
namespace {

// Longer than any wheel takes to turn round.
constexpr std::size_t max_rows_of_a_turn = 100;

std::int64_t size_at(std::span<const std::int64_t> counted, std::size_t row) {
  return std::abs(counted[row] - counted[row - 1]);
}

// Row `at` makes up for `excess` ticks more than it counted: twice what was counted since the wheel was
// slowest, and once what was counted then, when it went there and back. Returns the row in which it was
// slowest; `at` itself where no row fits.
std::size_t slowest_row(std::span<const std::int64_t> counted, std::size_t at, std::int64_t excess) {
  std::int64_t since = 0;
  for (std::size_t row = at - 1; row >= 1 && at - row <= max_rows_of_a_turn; --row) {
    const std::int64_t size = size_at(counted, row);
    if (2 * since + size == excess) return row;
    since += size;
    if (2 * since > excess) break;
  }
  return at;
}

std::vector<std::int64_t> changes_of(std::span<const std::int64_t> total) {
  std::vector<std::int64_t> changes(total.size(), 0);
  for (std::size_t row = 1; row < total.size(); ++row) changes[row] = total[row] - total[row - 1];
  return changes;
}

std::vector<std::int64_t> summed(std::int64_t first, const std::vector<std::int64_t>& changes) {
  std::vector<std::int64_t> total(changes.size(), first);
  for (std::size_t row = 1; row < changes.size(); ++row) total[row] = total[row - 1] + changes[row];
  return total;
}

// The changes of travel, each turn in the row in which the wheel was slowest, where it went there and back.
std::vector<std::int64_t> turned_in_time(std::span<const std::int64_t> counted,
                                         std::span<const std::int64_t> travel) {
  std::vector<std::int64_t> changes = changes_of(travel);
  for (std::size_t at = 2; at < changes.size(); ++at) {
    const std::int64_t change = travel[at] - travel[at - 1];
    const std::int64_t excess = std::abs(change) - size_at(counted, at);
    if (excess <= 0) continue;
    const std::size_t slowest = slowest_row(counted, at, excess);
    if (slowest == at) continue;
    const std::int64_t direction = change > 0 ? 1 : -1;
    changes[slowest] = 0;
    for (std::size_t row = slowest + 1; row <= at; ++row) changes[row] = direction * size_at(counted, row);
  }
  return changes;
}

// Of what was counted there and back in one row, what remains is about the mean of the rows around it.
void share_out_turns(std::span<const std::int64_t> counted, std::vector<std::int64_t>& changes) {
  for (std::size_t row = 1; row + 1 < changes.size(); ++row) {
    const std::int64_t size = size_at(counted, row);
    const bool turns = changes[row - 1] * changes[row + 1] < 0;
    if (!turns || changes[row] != 0 || size == 0) continue;
    const double mean = 0.5 * static_cast<double>(changes[row - 1] + changes[row + 1]);
    const auto size_m = static_cast<double>(size);
    const double forth = std::round(0.5 * (std::clamp(mean, -size_m, size_m) + size_m));
    changes[row] = 2 * std::llround(forth) - size;
  }
}

// How much the speed changes from one row to the next. Counts in the direction of a command jump where it
// changes; no wheel does.
double roughness(const std::vector<std::int64_t>& changes) {
  double sum = 0.0;
  for (std::size_t row = 1; row < changes.size(); ++row) {
    const auto jump = static_cast<double>(changes[row] - changes[row - 1]);
    sum += jump * jump;
  }
  return sum;
}

const ExtraColumn* column_of(const DriveLog& log, std::string_view name) {
  const auto column = std::ranges::find(log.extra_columns, name, &ExtraColumn::name);
  return column == log.extra_columns.end() ? nullptr : &*column;
}

// The samples hold the travel as it was known at the time afterwards; returns what was counted.
std::vector<WheelTicks> take_counts(DriveLog& log, const ExtraColumn& left, const ExtraColumn& right) {
  std::vector<WheelTicks> counted(log.samples.size());
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    DriveSample& sample = log.samples[row];
    if (!sample.ticks) continue;
    counted[row] = *sample.ticks;
    const bool known = std::isfinite(left.values[row]) && std::isfinite(right.values[row]);
    sample.ticks.reset();
    if (known) sample.ticks = {std::llround(left.values[row]), std::llround(right.values[row])};
  }
  return counted;
}

}  // namespace

std::vector<std::vector<std::int64_t>> sign_corrected_travel(std::span<const CountedTravel> runs) {
  std::vector<std::vector<std::int64_t>> as_counted;
  std::vector<std::vector<std::int64_t>> corrected;
  double rougher_by = 0.0;  // as counted
  for (const CountedTravel& run : runs) {
    as_counted.push_back(changes_of(run.counted));
    corrected.push_back(turned_in_time(run.counted, run.travel));
    share_out_turns(run.counted, corrected.back());
    rougher_by += roughness(as_counted.back()) - roughness(corrected.back());
  }
  const auto& changes = rougher_by > 0.0 ? corrected : as_counted;
  std::vector<std::vector<std::int64_t>> settled;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& travel = runs[i].travel;
    settled.push_back(travel.empty() ? travel : summed(travel.front(), changes[i]));
  }
  return settled;
}

void settle_travel(std::span<DriveLog> drives, std::span<const std::vector<WheelTicks>> counted) {
  constexpr std::array sides{&WheelTicks::left, &WheelTicks::right};
  std::vector<CountedTravel> runs;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    for (const auto side : sides) {
      CountedTravel& run = runs.emplace_back();
      for (std::size_t row = 0; row < drives[i].samples.size(); ++row) {
        const auto& ticks = drives[i].samples[row].ticks;
        if (!ticks) continue;
        run.counted.push_back(counted[i][row].*side);
        run.travel.push_back((*ticks).*side);
      }
    }
  }
  const auto settled = sign_corrected_travel(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto next = settled[i].begin();
    for (DriveSample& sample : drives[i / sides.size()].samples) {
      if (sample.ticks) (*sample.ticks).*sides.at(i % sides.size()) = *next++;
    }
  }
}

void take_sign_corrected_travel(std::span<DriveLog> runs) {
  std::vector<DriveLog> drives;
  std::vector<std::size_t> places;
  std::vector<std::vector<WheelTicks>> counted;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ExtraColumn* left = column_of(runs[i], "travel_ticks_left");
    const ExtraColumn* right = column_of(runs[i], "travel_ticks_right");
    if (left == nullptr || right == nullptr) continue;
    counted.push_back(take_counts(runs[i], *left, *right));
    places.push_back(i);
    drives.push_back(std::move(runs[i]));
  }
  settle_travel(drives, counted);
  for (std::size_t i = 0; i < drives.size(); ++i) runs[places[i]] = std::move(drives[i]);
}

}  // namespace wheelwright
