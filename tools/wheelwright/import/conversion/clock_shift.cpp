#include "tools/wheelwright/import/conversion/clock_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/clock_speeds.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"

namespace wheelwright::import {
namespace {

// Speeds are taken over these windows, the next one where the one before says nothing: poses that scatter by
// a centimetre show a speed over a second, and none over a tenth of it.
constexpr std::array windows_s{0.1, 0.3, 1.0, 3.0};
constexpr double fine_s = 0.01;
constexpr std::size_t max_fine_points = 400'000;  // more than an hour
constexpr double min_overlap_s = 5.0;
constexpr double min_correlation = 0.5;
// Correlation of a[i] and b[i - shift], i from `begin` to before `end`.
double correlation(const GridSpeeds& a, const GridSpeeds& b, long shift, long begin, long end) {
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (long i = begin; i < end; ++i) {
    const double va = a.values[static_cast<std::size_t>(i)];
    const double vb = b.values[static_cast<std::size_t>(i - shift)];
    n += 1;
    sa += va;
    sb += vb;
    saa += va * va;
    sbb += vb * vb;
    sab += va * vb;
  }
  const double variances = (saa - sa * sa / n) * (sbb - sb * sb / n);
  return variances > 0.0 ? (sab - sa * sb / n) / std::sqrt(variances) : 0.0;
}

// Where both are; 0 where less than half of the shorter is.
double correlation(const GridSpeeds& a, const GridSpeeds& b, long shift) {
  const auto size_a = static_cast<long>(a.values.size());
  const auto size_b = static_cast<long>(b.values.size());
  const long begin = std::max(0L, shift);
  const long end = std::min(size_a, size_b + shift);
  if (2 * (end - begin) < std::min(size_a, size_b)) return 0.0;
  return correlation(a, b, shift, begin, end);
}

struct Best {
  long shift = 0;
  double correlation = 0.0;
};

Best best_shift(const GridSpeeds& robot, const GridSpeeds& reference, long from, long to) {
  Best best;
  for (long shift = from; shift <= to; ++shift) {
    const double found = correlation(robot, reference, shift);
    if (found > best.correlation) best = {shift, found};
  }
  return best;
}

// Over all shifts of whole windows.
Best coarse_shift(const GridSpeeds& robot, const GridSpeeds& reference) {
  return best_shift(robot, reference, -static_cast<long>(reference.values.size()),
                    static_cast<long>(robot.values.size()));
}

// The clock of a reference that goes faster or slower than that of the robot.
struct Drift {
  double rate = 1.0;
  double first_shift_s = 0.0;  // of the first stamp of the reference
};

// The shift of one part of a drive.
struct PartShift {
  double reference_s = 0.0;  // in the middle of the part, by the clock of the reference
  double shift_s = 0.0;
};

// Shifts of parts of the drive, near the one that is best for all of it; without those whose speeds do not
// agree.
std::vector<PartShift> part_shifts(const GridSpeeds& robot, const GridSpeeds& reference, long shift) {
  constexpr long parts = 8;
  constexpr double largest_drift = 0.01;
  constexpr double max_lag_s = 0.3;
  constexpr double clear_correlation = 0.8;
  const long begin = std::max(0L, shift);
  const long end =
      std::min(static_cast<long>(robot.values.size()), static_cast<long>(reference.values.size()) + shift);
  const auto reach = std::lround(max_lag_s / fine_s + largest_drift * static_cast<double>(end - begin));
  std::vector<PartShift> found;
  for (long part = 0; part < parts; ++part) {
    const long from = begin + (end - begin) * part / parts;
    const long to = begin + (end - begin) * (part + 1) / parts;
    Best best;
    for (long tried = shift - reach; tried <= shift + reach; ++tried) {
      if (from - tried < 0 || to - tried > static_cast<long>(reference.values.size())) continue;
      const double agreement = correlation(robot, reference, tried, from, to);
      if (agreement > best.correlation) best = {tried, agreement};
    }
    const bool is_at_an_end = std::abs(best.shift - shift) == reach;
    if (best.correlation < clear_correlation || is_at_an_end) continue;
    const double robot_s = robot.start_s + 0.5 * fine_s * static_cast<double>(from + to);
    const double shift_s = robot.start_s - reference.start_s + fine_s * static_cast<double>(best.shift);
    found.push_back({robot_s - shift_s, shift_s});
  }
  return found;
}

// A line through the shifts by the median of the slopes between any two (Theil and Sen), which a part that is
// wrong does not turn.
std::optional<Drift> find_drift(const std::vector<PartShift>& parts, double first_stamp_s) {
  constexpr std::size_t min_parts = 5;
  constexpr double visible_s = 0.03;
  constexpr double times_the_scatter = 5.0;
  if (parts.size() < min_parts) return std::nullopt;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      slopes.push_back((parts[j].shift_s - parts[i].shift_s) / (parts[j].reference_s - parts[i].reference_s));
  const double slope = median(std::move(slopes));
  std::vector<double> at_first;
  at_first.reserve(parts.size());
  for (const PartShift& part : parts)
    at_first.push_back(part.shift_s - slope * (part.reference_s - first_stamp_s));
  const double first_shift_s = median(std::vector<double>(at_first));
  for (double& each : at_first) each = std::abs(each - first_shift_s);
  const double scatter_s = std::max(median(std::move(at_first)), 0.5 * fine_s);
  const double drifted_s = std::abs(slope) * (parts.back().reference_s - parts.front().reference_s);
  if (drifted_s < visible_s || drifted_s < times_the_scatter * scatter_s) return std::nullopt;
  return Drift{1.0 + slope, first_shift_s};
}

std::optional<double> first_finite(const std::vector<double>& values) {
  const auto found = std::ranges::find_if(values, [](double value) { return std::isfinite(value); });
  return found == values.end() ? std::nullopt : std::optional(*found);
}

std::string in_words(const ClockShift& shift, double agreement) {
  std::string words =
      "the clock of the reference is shifted by " + config::fixed_number(shift.seconds, 3) + " s";
  if (shift.rate != 1.0)
    words += " at its first stamp, and is " + std::string(shift.rate > 1.0 ? "slow" : "fast") + " by " +
             config::fixed_number(100.0 * std::abs(shift.rate - 1.0), 3) + " %";
  return words + ": there its speed and that of the robot agree best (correlation " +
         config::fixed_number(agreement, 2) + ")";
}

std::string said_to_begin_together(const GridSpeeds& robot, const GridSpeeds& reference) {
  return "if both began together: --set reference.shift_s=" +
         config::fixed_number(robot.start_s - reference.start_s, 3);
}

}  // namespace

tl::expected<ClockShift, std::string> find_clock_shift(std::span<const Recording> recordings,
                                                       const Mapping& mapping) {
  if (!mapping.reference->x || !mapping.reference->y)
    return tl::unexpected(std::string(
        "a reference without places has no clock to compare; give its shift: --set reference.shift_s=0"));
  const FoundChannel x = find_channel(recordings, *mapping.reference->x);
  const auto first_stamp = x.stream != nullptr ? first_finite(stream_times(*x.stream, mapping.time)) : 0.0;
  if (!first_stamp)
    return tl::unexpected(std::string(
        "the reference has no time; say how far its rows or frames are apart: --set time.rate_hz=100"));
  double most = 0.0;
  std::string together;
  for (const double window_s : windows_s) {
    const SpeedGrid coarse_grid{window_s, window_s};  // more than an hour of it
    const GridSpeeds robot = robot_speeds(recordings, mapping, coarse_grid);
    const GridSpeeds reference = reference_speeds(recordings, mapping, coarse_grid);
    const auto overlap = static_cast<double>(std::min(robot.values.size(), reference.values.size()));
    if (overlap * window_s < min_overlap_s) {
      return tl::unexpected(
          "too little of the robot or its reference moves to compare their clocks; give the shift; " +
          said_to_begin_together(robot, reference));
    }
    const Best coarse = coarse_shift(robot, reference);
    most = std::max(most, coarse.correlation);
    together = said_to_begin_together(robot, reference);
    if (coarse.correlation < min_correlation) continue;
    const SpeedGrid grid{fine_s, window_s, max_fine_points};
    const long per_window = std::lround(window_s / fine_s);
    const GridSpeeds fine_robot = robot_speeds(recordings, mapping, grid);
    const GridSpeeds fine_reference = reference_speeds(recordings, mapping, grid);
    const Best fine = best_shift(fine_robot, fine_reference, (coarse.shift - 2) * per_window,
                                 (coarse.shift + 2) * per_window);
    const long shift = fine.correlation > 0.0 ? fine.shift : coarse.shift * per_window;
    ClockShift result;
    result.seconds = robot.start_s - reference.start_s + fine_s * static_cast<double>(shift);
    if (const auto drift = find_drift(part_shifts(fine_robot, fine_reference, shift), *first_stamp)) {
      result.seconds = drift->first_shift_s;
      result.rate = drift->rate;
    }
    result.correlation = coarse.correlation;
    result.evidence = in_words(result, coarse.correlation);
    return result;
  }
  return tl::unexpected(
      "the speed of the reference fits that of the robot at no shift of its clock (correlation " +
      config::fixed_number(most, 2) + " at best); give the shift; " + together);
}

}  // namespace wheelwright::import
