#include "tools/wheelwright/gap/check_section.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/number_text.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t max_statistics_shown = 6;

std::string p_text(double p_value) {
  if (p_value < 1e-4) return "p < 0.0001";
  return "p = " + (p_value > 0.995 ? "1" : short_number(p_value));
}

std::string curve_of(const gap::CheckStatistic& failed) {
  PlotPoints points;
  for (const auto& [x, y] : failed.curve.points) points.push_back({x, y});
  if (points.empty()) return "";
  Plot plot(failed.name);
  plot.axes(failed.curve.x_axis, failed.curve.y_axis).height(260);
  plot.line("", Ink::accent, points).points("", Ink::accent, points);
  const std::array plots{plot};
  return figures_html(draw(plots));
}

}  // namespace

std::string test_runs_text(const gap::GapAnalysis& analysis) {
  return analysis.untouched ? "untouched" : "held out";
}

std::string checked_text(gap::CheckedRuns checked) {
  switch (checked) {
    case gap::CheckedRuns::untouched:
      return "untouched";
    case gap::CheckedRuns::held_out:
      return "held-out";
    case gap::CheckedRuns::all:
      break;
  }
  return "all";
}

namespace {

std::string role_text(gap::CheckedRuns checked) {
  switch (checked) {
    case gap::CheckedRuns::untouched:
      return "These runs took no part in any choice.";
    case gap::CheckedRuns::held_out:
      return "These runs also decided which effects were accepted: there were too few to keep some "
             "untouched, and the "
             "answer is not confirmed on untouched data.";
    case gap::CheckedRuns::all:
      break;
  }
  return "No effect was chosen by free runs, so that no run took part in a choice, and all are checked.";
}

}  // namespace

std::string check_text(const gap::GapAnalysis& analysis) {
  const gap::PredictiveCheck& check = analysis.check;
  if (check.statistics.empty()) return "";
  std::string text = "check on " + checked_text(analysis.checked) + " runs: ";
  if (check.passed) return text + "passed (" + p_text(check.p_value) + ")";
  return text + "failed (" + p_text(check.p_value) + "): " + check.statistics.front().sentence;
}

std::string check_section(const gap::GapAnalysis& analysis) {
  const gap::PredictiveCheck& check = analysis.check;
  if (check.statistics.empty()) return "";
  Rows rows;
  for (const auto& statistic : check.statistics) {
    if (rows.size() == max_statistics_shown) break;
    rows.push_back({statistic.name, p_text(statistic.p_value), statistic.visible ? "yes" : "no"});
  }
  std::string text = html::element("h2", "Is the model enough?");
  text += html::element("p", std::string(check.passed ? "Yes" : "No") + ", by the " + check_text(analysis) +
                                 ". " + role_text(analysis.checked));
  if (!check.passed) text += curve_of(check.statistics.front());
  text += html::table({"statistic of the innovations", "p-value", "large enough to be seen"}, rows);
  return text +
         "<p class=\"quiet\">The smallest p-value of those that are large enough to be seen, corrected for "
         "the "
         "number of statistics, is compared with " +
         fixed_number(gap::check_level, 2) + ".</p>\n";
}

std::string linear_changes_section(const gap::GapAnalysis& analysis) {
  if (analysis.linear_changes.empty()) return "";
  Rows rows;
  for (const auto& change : analysis.linear_changes) {
    rows.push_back(
        {std::string(change.what), std::string(change.wheel), short_number(change.value),
         "[" + short_number(change.interval.lower) + ", " + short_number(change.interval.upper) + "]",
         change.unit == "1" ? "times" : "s more"});
  }
  return html::element("h2", "What the linear part of the given model has wrong") +
         html::table({"what", "wheel", "data against the model", "95 % interval", "unit"}, rows);
}

}  // namespace wheelwright::tools
