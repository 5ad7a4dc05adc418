#include "tools/wheelwright/report/lateness_section.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

constexpr double boxes_per_octave = 4.0;

std::string table_of(const daemon::LatenessRecord& record) {
  const auto lateness = [](double value_us) { return fixed_number(value_us, value_us < 10.0 ? 1 : 0); };
  return html::table({"the sensor loop", "", ""},
                     {{"system", record.system, ""},
                      {"period", fixed_number(1e3 * record.period_s, 1), "ms"},
                      {"wake-ups", std::to_string(record.wake_ups), ""},
                      {"half of them late by less than", lateness(record.quantile_us(0.5)), "us"},
                      {"99 % late by less than", lateness(record.quantile_us(0.99)), "us"},
                      {"99.9 % late by less than", lateness(record.quantile_us(0.999)), "us"},
                      {"the latest", lateness(record.largest_us), "us"},
                      {"late by a period or more", std::to_string(record.overruns), ""},
                      {"periods skipped for it", std::to_string(record.skipped_periods), ""},
                      {"ticks without a command in time", std::to_string(record.commands_late), ""}});
}

Plot histogram_of(const daemon::LatenessRecord& record) {
  Plot plot(
      "How late the sensor loop woke up: wake-ups per step of lateness, four steps to each doubling; both "
      "axes are logarithmic. Marked: what 99 % stayed below, and the period.");
  plot.axes("lateness [us]", "wake-ups");
  constexpr double below_one = 0.5;  // a box of a single wake-up has some height
  plot.logarithmic(1.3 * std::max(record.largest_us, 1e6 * record.period_s), below_one);
  PlotPoints boxes;
  for (const LatenessBox& box : lateness_boxes(record)) {
    boxes.push_back({0.5 * (box.lower_edge_us + box.upper_edge_us), static_cast<double>(box.wake_ups),
                     0.5 * (box.upper_edge_us - box.lower_edge_us)});
  }
  plot.boxes("", Ink::accent, boxes);
  plot.mark(record.quantile_us(0.99), "99 %").mark(1e6 * record.period_s, "period");
  return plot;
}

}  // namespace

std::vector<LatenessBox> lateness_boxes(const daemon::LatenessRecord& record) {
  constexpr double min_us = 0.1;  // where the finest bin ends
  std::vector<LatenessBox> boxes;
  for (const daemon::LatenessBin& bin : record.bins) {
    const double edge_us = std::max(bin.upper_edge_us, min_us);
    // An edge between two boxes belongs to the lower one, also where it was rounded to the nanosecond.
    const double step = std::ceil(boxes_per_octave * std::log2(edge_us / min_us) - 0.01);
    const double upper_us = min_us * std::exp2(step / boxes_per_octave);
    if (boxes.empty() || boxes.back().upper_edge_us < upper_us)
      boxes.push_back({upper_us * std::exp2(-1.0 / boxes_per_octave), upper_us, 0});
    boxes.back().wake_ups += bin.wake_ups;
  }
  return boxes;
}

std::string lateness_section(const daemon::LatenessRecord& record) {
  const std::vector<Plot> plots{histogram_of(record)};
  return html::element("h2", "How late the loop was") + table_of(record) + figures_html(draw(plots));
}

}  // namespace wheelwright::tools
