#include "tools/wheelwright/import/conversion/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "config/load/text_format.hpp"
#include "model/log/heading_offset.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/missing_keys.hpp"
#include "tools/wheelwright/import/conversion/run_maker.hpp"
#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"

namespace wheelwright::import {
namespace {

// Rows may be missing, but not by the hundred. They may lie between the periods: a simulator writes each of
// its own steps, down to a tenth of a millisecond.
std::string period_contradiction(const DriveLog& log) {
  constexpr double max_periods_per_row = 50.0;
  constexpr double max_rows_per_period = 600.0;
  std::vector<double> t_s;
  for (const auto& sample : log.samples) t_s.push_back(sample.t_s);
  const double step_s = median_step_s(t_s);
  if (log.period_s <= max_rows_per_period * step_s && step_s <= max_periods_per_row * log.period_s) return {};
  return "rows are " + config::plain_number(step_s) + " s apart (median), but the period is said to be " +
         config::plain_number(log.period_s) +
         " s; correct it, or say the unit of the time: --set time.unit=ms";
}

// Rows closer together than the period are no contradiction (a command may hold for many), but seldom meant.
// A reference whose clock was shifted by hand, and none of whose poses falls into the drive.
std::string missed_reference(const std::vector<DriveLog>& runs, const Mapping& mapping) {
  if (!mapping.reference || !mapping.reference->shift_s) return {};
  const bool has_any = std::ranges::any_of(runs, [](const DriveLog& run) {
    return std::ranges::any_of(run.samples, [](const DriveSample& sample) {
      return sample.reference_x_m.has_value() || sample.reference_theta_rad.has_value();
    });
  });
  if (has_any) return {};
  return "with reference.shift_s=" + config::plain_number(*mapping.reference->shift_s) +
         " no pose of the reference falls into the drive; leave it out, and the shift is looked for";
}

void doubt_period(const DriveLog& log, std::vector<std::string>& remarks) {
  constexpr double much_closer = 1.5;
  std::vector<double> t_s;
  for (const auto& sample : log.samples) t_s.push_back(sample.t_s);
  const double step_s = median_step_s(t_s);
  if (log.period_s < much_closer * step_s) return;
  const std::string remark =
      "rows are " + config::fixed_number(step_s, 4) + " s apart (median), though the period is said to be " +
      config::plain_number(log.period_s) + " s; --set time.period_s=" + config::fixed_number(step_s, 4) +
      " if that is wrong";
  if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
}

// A few clocks that were set, or a new run every few seconds, are possible; in every twentieth row they are
// not.
bool is_out_of_order(const TimeRepair& time) {
  return time.set_back > 10 && 20 * time.set_back > time.t_s.size();
}

// A log that writes counts only where they changed writes every column so.
bool is_written_on_change(const DriveColumns& columns) {
  const std::array<const Column*, 3> references{&columns.x, &columns.y, &columns.theta_rad};
  return !columns.has_misread_counts && std::ranges::any_of(columns.wheel, is_log_on_change) &&
         std::ranges::any_of(references, [](const Column* column) { return is_log_on_change(*column); });
}

DriveColumns filled(DriveColumns columns) {
  for (Column* column : {&columns.x, &columns.y, &columns.theta_rad, &columns.gyro, &columns.battery})
    fill_down(*column);
  return columns;
}

// Where distances of wheels and reference cannot be compared: the scale of one was found from the other, or
// from the commands.
std::string scale_found_from(const Mapping& mapping) {
  if (mapping.wheels && !mapping.wheels->scale_from.empty()) return mapping.wheels->scale_from;
  const bool by_robot = mapping.reference && mapping.reference->scale_from_robot;
  return by_robot ? "reference" : "";
}

// A tracker does not know where the robot's front is; its motion shows it.
void turn_headings_back(Conversion& conversion, const Mapping& mapping) {
  if (!mapping.reference || mapping.reference->heading_offset_deg) return;
  std::vector<const DriveLog*> runs;
  runs.reserve(conversion.runs.size());
  for (const DriveLog& run : conversion.runs) runs.push_back(&run);
  const auto offsets = heading_offsets(runs);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (!is_turned(offsets[i])) continue;
    turn_headings(conversion.runs[i], offsets[i]);
    const std::string remark =
        in_words(offsets[i]) + "; it was turned back (--set reference.heading_offset_deg if you know it)";
    if (std::ranges::find(conversion.remarks, remark) == conversion.remarks.end())
      conversion.remarks.push_back(remark);
  }
}

// The whole seconds of stamps go on while the parts of a second go back.
bool are_nanoseconds_without_zeros(const Column& t_s) {
  constexpr int min_seconds = 3;
  int seconds = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (const double t : t_s) {
    if (!std::isfinite(t)) continue;
    if (std::floor(t) < last) return false;
    if (std::floor(t) > last) ++seconds;
    last = std::floor(t);
  }
  return seconds >= min_seconds;
}

}  // namespace

tl::expected<Conversion, std::string> convert(const DriveColumns& columns, const Mapping& mapping,
                                              const std::string& name) {
  if (const auto missing = what_is_missing(mapping); !missing.empty())
    return tl::unexpected(name + ": " + missing);
  if (is_written_on_change(columns)) return convert(filled(columns), mapping, name);
  Conversion conversion;
  TimeRepair time = repair_runs(columns, mapping);
  if (is_out_of_order(time)) {
    return tl::unexpected(name + ": the clock goes back " + std::to_string(time.set_back) + " times in " +
                          std::to_string(time.t_s.size()) + " rows: they are not in the order of time; " +
                          (are_nanoseconds_without_zeros(columns.t_s)
                               ? "the whole seconds are, so that nanoseconds were written behind the point "
                                 "without their leading zeros (521.5 for 521.000000005): write nine digits, "
                                 "or seconds and nanoseconds in two columns"
                               : "sort the rows by their time"));
  }
  conversion.remarks = columns.remarks;
  conversion.remarks.insert(conversion.remarks.end(), time.remarks.begin(), time.remarks.end());
  for (const auto& rows : time.runs) {
    DriveLog log = make_run(columns, time.t_s, mapping, name, rows, conversion.remarks);
    if (log.samples.size() < 2) continue;
    if (const auto contradiction = period_contradiction(log); !contradiction.empty()) {
      return tl::unexpected(name + ": " + contradiction);
    }
    doubt_period(log, conversion.remarks);
    if (is_one_wheel(mapping)) log.other_metadata.emplace_back("one_wheel", "left");
    if (const std::string scale_from = scale_found_from(mapping); !scale_from.empty())
      log.other_metadata.emplace_back(scale_from_key, scale_from);
    if (!mapping.robot.empty()) log.other_metadata.emplace_back("robot", mapping.robot);
    for (const auto& entry : mapping_entries(mapping)) {
      log.other_metadata.emplace_back("mapping." + entry.key, entry.value);
    }
    conversion.runs.push_back(std::move(log));
  }
  if (conversion.runs.empty()) return tl::unexpected(name + ": no run of two rows with a time and a command");
  if (const auto missed = missed_reference(conversion.runs, mapping); !missed.empty())
    return tl::unexpected(name + ": " + missed);
  turn_headings_back(conversion, mapping);
  return conversion;
}

}  // namespace wheelwright::import
