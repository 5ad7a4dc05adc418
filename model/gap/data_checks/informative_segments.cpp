#include "model/gap/data_checks/informative_segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

namespace wheelwright::gap {
namespace {

constexpr double rest_s = 1.0;          // before a segment: wheels that were told to stand have come to rest
constexpr double unknown_past_s = 2.0;  // of a past that is not known, where a robot never stands
constexpr double enough_s = 2.0;        // of anything; more of it adds less and less
constexpr double change_is_worth_s = 1.0;

struct Range {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void add(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  // 0 .. count - 1.
  std::size_t part_of(double value, std::size_t count) const {
    if (!(highest > lowest)) return 0;
    const double share = std::clamp((value - lowest) / (highest - lowest), 0.0, 1.0);
    return std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)));
  }
};

// In which ranges all logs together move.
struct Ranges {
  Range command_m_s;
  Range turn_m_s;  // right less left
  Range change_m_s;
  Range x_m;
  Range y_m;
  Range battery_v;
};

Ranges ranges_of(std::span<const DriveLog> logs) {
  Ranges ranges;
  for (const DriveLog& log : logs) {
    for (const DriveSample& sample : log.samples) {
      const WheelPair& command = sample.command_m_s;
      for (const double one : {command.left, command.right, -command.left, -command.right}) {
        ranges.command_m_s.add(one);
        ranges.change_m_s.add(2.0 * one);
      }
      ranges.turn_m_s.add(command.right - command.left);
      if (sample.reference_x_m) ranges.x_m.add(*sample.reference_x_m);
      if (sample.reference_y_m) ranges.y_m.add(*sample.reference_y_m);
      if (sample.battery_v) ranges.battery_v.add(*sample.battery_v);
    }
  }
  return ranges;
}

// How long a segment holds each kind of thing.
class Content {
 public:
  static constexpr std::size_t levels = 16;
  static constexpr std::size_t coarse = 8;
  static constexpr std::size_t side = 16;  // of the floor, in cells
  static constexpr std::size_t left = 0;
  static constexpr std::size_t right = left + levels;
  static constexpr std::size_t together = right + levels;
  static constexpr std::size_t changes = together + coarse * coarse;
  static constexpr std::size_t reversals = changes + 2 * levels;
  static constexpr std::size_t headings = reversals + 2;
  static constexpr std::size_t places = headings + coarse;
  static constexpr std::size_t battery = places + side * side;
  static constexpr std::size_t parts = battery + coarse;
  static constexpr std::size_t size = parts + coarse;

  void add(std::size_t kind, double duration_s) { time_s_[kind] += static_cast<float>(duration_s); }
  double time_s(std::size_t kind) const { return time_s_[kind]; }

 private:
  std::array<float, size> time_s_{};
};

struct Segment {
  std::size_t log = 0;
  std::size_t first = 0;  // rows
  std::size_t last = 0;   // behind them
  bool from_rest = false;
  Content content;

  std::size_t rows() const { return last - first; }
};

void add_command(const Ranges& ranges, const WheelPair& command, double duration_s, Content& content) {
  const Range& range = ranges.command_m_s;
  content.add(Content::left + range.part_of(command.left, Content::levels), duration_s);
  content.add(Content::right + range.part_of(command.right, Content::levels), duration_s);
  const double middle = 0.5 * (command.left + command.right);
  content.add(Content::together + Content::coarse * range.part_of(middle, Content::coarse) +
                  ranges.turn_m_s.part_of(command.right - command.left, Content::coarse),
              duration_s);
}

void add_change(const Ranges& ranges, const WheelPair& from, const WheelPair& to, Content& content) {
  const std::array<std::pair<double, double>, 2> wheels{{{from.left, to.left}, {from.right, to.right}}};
  for (std::size_t wheel = 0; wheel < wheels.size(); ++wheel) {
    const auto& [before, after] = wheels[wheel];
    if (before == after) continue;
    const std::size_t part = ranges.change_m_s.part_of(after - before, Content::levels);
    content.add(Content::changes + wheel * Content::levels + part, change_is_worth_s);
    if (before * after < 0.0) content.add(Content::reversals + wheel, change_is_worth_s);
  }
}

void add_step_context(const Ranges& ranges, const DriveSample& sample, double duration_s, Content& content) {
  if (sample.reference_theta_rad) {
    const double turns = *sample.reference_theta_rad / (2.0 * std::numbers::pi);
    const Range turn{0.0, 1.0};
    content.add(Content::headings + turn.part_of(turns - std::floor(turns), Content::coarse), duration_s);
  }
  if (sample.reference_x_m && sample.reference_y_m) {
    content.add(Content::places + Content::side * ranges.x_m.part_of(*sample.reference_x_m, Content::side) +
                    ranges.y_m.part_of(*sample.reference_y_m, Content::side),
                duration_s);
  }
  if (sample.battery_v) {
    content.add(Content::battery + ranges.battery_v.part_of(*sample.battery_v, Content::coarse), duration_s);
  }
}

Content content_of(const DriveLog& log, const Segment& segment, const Ranges& ranges) {
  Content content;
  const Range whole{log.samples.front().t_s, log.samples.back().t_s};
  for (std::size_t row = segment.first; row + 1 < segment.last; ++row) {
    const DriveSample& sample = log.samples[row];
    const double duration_s = std::min(log.samples[row + 1].t_s - sample.t_s, 10.0 * log.period_s);
    add_command(ranges, sample.command_m_s, duration_s, content);
    add_change(ranges, sample.command_m_s, log.samples[row + 1].command_m_s, content);
    add_step_context(ranges, sample, duration_s, content);
    content.add(Content::parts + whole.part_of(sample.t_s, Content::coarse), duration_s);
  }
  return content;
}

bool is_rest(const DriveSample& sample) {
  return sample.command_m_s.left == 0.0 && sample.command_m_s.right == 0.0;
}

// The first row from `from` on at which the robot has been told to stand for a while.
std::optional<std::size_t> rest_from(const DriveLog& log, std::size_t from, double until_s) {
  const auto& samples = log.samples;
  std::optional<std::size_t> since;
  for (std::size_t row = from; row < samples.size() && samples[row].t_s < until_s; ++row) {
    if (!is_rest(samples[row])) {
      since.reset();
    } else if (!since) {
      since = row;
    }
    if (since && samples[row].t_s - samples[*since].t_s >= rest_s) return row;
  }
  return std::nullopt;
}

// A log with counts begins with some.
std::size_t first_with_counts(const DriveLog& log, std::size_t row) {
  while (log.has_ticks() && row < log.samples.size() && !log.samples[row].ticks) ++row;
  return row;
}

std::vector<Segment> segments_of(std::span<const DriveLog> logs, double length_s) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const auto& samples = logs[i].samples;
    std::size_t next = 0;
    while (next < samples.size()) {
      const double from_s = samples[next].t_s;
      const bool begins = next == 0;
      const auto rest = begins ? std::optional(next) : rest_from(logs[i], next, from_s + length_s);
      const std::size_t first = first_with_counts(logs[i], rest.value_or(next));
      std::size_t last = first;
      while (last < samples.size() && samples[last].t_s < samples[first].t_s + length_s) ++last;
      if (first < samples.size() && (last < samples.size() || begins)) {
        segments.push_back({i, first, last, begins || rest.has_value(), {}});
      }
      next = std::max(last, next + 1);
    }
  }
  return segments;
}

double worth(const Content& chosen, const Content& segment) {
  double sum = 0.0;
  for (std::size_t kind = 0; kind < Content::size; ++kind) {
    const double more_s = segment.time_s(kind);
    if (more_s > 0.0) sum += std::log1p(more_s / (enough_s + chosen.time_s(kind)));
  }
  return sum;
}

// One after the other, each for what it adds; those that begin at rest before all others.
std::vector<Segment> chosen_of(std::vector<Segment> segments, std::size_t max_rows) {
  const auto standing = std::partition(segments.begin(), segments.end(), std::mem_fn(&Segment::from_rest));
  std::size_t at_rest_rows = 0;
  for (auto segment = segments.begin(); segment != standing; ++segment) at_rest_rows += segment->rows();
  if (at_rest_rows >= max_rows) segments.erase(standing, segments.end());
  std::vector<Segment> chosen;
  Content all;
  std::size_t rows = 0;
  while (!segments.empty()) {
    std::vector<double> worths(segments.size());
    std::ranges::transform(segments, worths.begin(),
                           [&](const Segment& segment) { return worth(all, segment.content); });
    const auto best = segments.begin() + (std::ranges::max_element(worths) - worths.begin());
    if (rows + best->rows() > max_rows && !chosen.empty()) break;
    rows += best->rows();
    for (std::size_t kind = 0; kind < Content::size; ++kind) all.add(kind, best->content.time_s(kind));
    chosen.push_back(*best);
    segments.erase(best);
  }
  std::ranges::sort(chosen, {}, [](const Segment& one) { return std::pair(one.log, one.first); });
  return chosen;
}

// Begins from rest, or with a while of which only the commands are told.
DriveLog cut_out(const DriveLog& log, const Segment& segment) {
  DriveLog part;
  part.name = log.name;
  part.wheel_base_m = log.wheel_base_m;
  part.period_s = log.period_s;
  part.metres_per_tick = log.metres_per_tick;
  part.references_late_s = log.references_late_s;
  part.reference_response = log.reference_response;
  part.reference_scaled_by_counts = log.reference_scaled_by_counts;
  part.other_metadata = log.other_metadata;
  part.first_line = log.first_line + segment.first;
  const auto begin = log.samples.begin();
  part.samples.assign(begin + static_cast<std::ptrdiff_t>(segment.first),
                      begin + static_cast<std::ptrdiff_t>(segment.last));
  if (segment.from_rest) return part;
  const double known_s = part.samples.front().t_s + unknown_past_s;
  for (DriveSample& sample : part.samples) {
    if (sample.t_s >= known_s) break;
    if (&sample != &part.samples.front()) sample.ticks.reset();
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
    sample.reference_theta_rad.reset();
  }
  return part;
}

double duration_s(const DriveLog& log) {
  return log.samples.back().t_s - log.samples.front().t_s;
}

}  // namespace

Segments informative_segments(std::vector<DriveLog> logs, const SegmentLimits& limits) {
  Segments result;
  std::size_t rows = 0;
  for (const DriveLog& log : logs) {
    result.given_s += duration_s(log);
    rows += log.samples.size();
  }
  if (rows <= limits.max_rows) {
    result.used_s = result.given_s;
    result.runs = std::move(logs);
    return result;
  }
  const Ranges ranges = ranges_of(logs);
  std::vector<Segment> segments = segments_of(logs, limits.length_s);
  for (Segment& segment : segments) segment.content = content_of(logs[segment.log], segment, ranges);
  for (const Segment& segment : chosen_of(std::move(segments), limits.max_rows)) {
    result.runs.push_back(cut_out(logs[segment.log], segment));
    result.used_s += duration_s(result.runs.back());
  }
  return result;
}

}  // namespace wheelwright::gap
