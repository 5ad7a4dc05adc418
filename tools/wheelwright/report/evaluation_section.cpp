#include "tools/wheelwright/report/evaluation_section.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/load/csv_table.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/evaluation/candidate.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/plot.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;
using config::fixed_number;
using nlohmann::json;
using Rows = std::vector<std::vector<std::string>>;

json load_evaluation(const fs::path& path) {
  json result = load_json(path);
  if (!result.is_object() || !result.contains("models")) {
    throw UsageError(
        path.string() +
        ": is not what wheelwright evaluate writes; write the folder again with wheelwright evaluate -o");
  }
  return result;
}

std::string with_interval(const json& figure) {
  if (figure.is_null()) return "-";
  const json& interval = figure["ci95"];
  const std::string between =
      interval.is_null() ? "-" : fixed_number(interval[0], 3) + ", " + fixed_number(interval[1], 3);
  return fixed_number(figure["value"], 3) + " [" + between + "]";
}

std::string table(const json& models) {
  Rows rows;
  for (const Candidate& candidate : candidates) {
    const std::string key(candidate.key);
    if (!models.contains(key)) continue;
    const json& model = models[key];
    const bool published = candidate.published.has_value();
    rows.push_back({std::string(candidate.title), with_interval(model.value("mean_offset", json())),
                    with_interval(model.value("standard_deviation", json())),
                    published ? fixed_number(candidate.published->mean_m, 3) : "-",
                    published ? fixed_number(candidate.published->standard_deviation_m, 3) : "-",
                    model.contains("met") ? (model["met"].get<bool>() ? "yes" : "no") : "-",
                    std::to_string(model["finished"].get<int>()) + " of " +
                        std::to_string(model["attempts"].get<int>())});
  }
  return html::table({"model", "mean offset, m", "std. deviation, m", "published mean, m",
                      "published std., m", "met", "attempts that ended"},
                     rows) +
         "<p class=\"quiet\">Offset: true distance from start to end of the closed route. Brackets: 95 % "
         "intervals by "
         "bootstrap over attempts. Met: the mean is at most 30 % above the published one.</p>\n";
}

PlotPoints end_points(const config::CsvTable& csv, std::string_view key) {
  const auto model = csv.find("model");
  const auto x = csv.numbers("x");
  const auto y = csv.numbers("y");
  PlotPoints points;
  for (std::size_t row = 0; model && row < csv.rows(); ++row) {
    if (csv.text(row, *model) == key) points.push_back({x[row], y[row]});
  }
  return points;
}

// Half the width of every picture, so that they compare: all end points and published circles fit.
double half_width_m(const config::CsvTable& csv) {
  double farthest_m = 0.0;
  for (const char* column : {"x", "y"}) {
    for (const double value : csv.numbers(column)) farthest_m = std::max(farthest_m, std::abs(value));
  }
  for (const Candidate& candidate : candidates) {
    if (candidate.published) farthest_m = std::max(farthest_m, candidate.published->mean_m);
  }
  return 1.05 * farthest_m;
}

}  // namespace

bool is_evaluation(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "end_points.csv", ignored);
}

std::string evaluation_section(const fs::path& folder) {
  const json evaluation = load_evaluation(folder / "evaluation.json");
  const auto csv = config::CsvTable::load(folder / "end_points.csv");
  const double half_m = half_width_m(csv);
  std::vector<Plot> plots;
  for (const Candidate& candidate : candidates) {
    PlotPoints points = end_points(csv, candidate.key);
    if (points.empty()) continue;
    Plot& plot = plots.emplace_back(std::string(candidate.title) +
                                    (candidate.published ? "; dashed: the published mean offset" : ""));
    plot.axes("x [m]", "y [m]").half().height(420).range(half_m).equal_scales();
    if (candidate.published) plot.circle(0.0, 0.0, candidate.published->mean_m, 2);
    plot.line("", Ink::quiet, {{-half_m, 0.0}, {half_m, 0.0}});
    plot.line("", Ink::quiet, {{0.0, -half_m}, {0.0, half_m}});
    plot.points("", Ink::accent, std::move(points), 0.5);
  }
  std::string text = html::element("h2", "Where the robot ended");
  text += html::element(
      "p", std::to_string(evaluation.value("runs", 0)) + " attempts per model, robot '" +
               evaluation.value("robot", "") + "', closed route '" + evaluation.value("route", "") +
               "', seed " + std::to_string(evaluation.value("seed", 0)) +
               ". Each point is the true end of one attempt as seen from its start, in the middle.");
  return text + table(evaluation["models"]) + figures_html(draw(plots));
}

}  // namespace wheelwright::tools
