#include "tools/wheelwright/evaluation/offset_table.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using nlohmann::ordered_json;

bool is_met(const OffsetRow& row) {
  if (row.finished < row.attempts || !row.offset) return false;
  const double published_m = row.candidate.published->mean_m;
  return row.offset->mean_m <= (1.0 + mean_tolerance) * published_m;
}

std::string metres(double value_m) {
  return fixed_number(value_m, 3);
}

std::string with_interval(const std::optional<double>& value_m, const std::optional<Interval>& interval_m) {
  if (!value_m) return "-";
  const std::string between = interval_m ? metres(interval_m->low) + ", " + metres(interval_m->high) : "-";
  return metres(*value_m) + " [" + between + "]";
}

ordered_json to_json(double value, const std::optional<Interval>& interval) {
  ordered_json json{{"value", value}, {"unit", "m"}, {"ci95", nullptr}};
  if (interval) json["ci95"] = {interval->low, interval->high};
  return json;
}

std::string published_text(const OffsetRow& row) {
  if (!row.candidate.published) return "-";
  return metres(row.candidate.published->mean_m) + " +- " +
         metres(row.candidate.published->standard_deviation_m);
}

std::string mean_and_deviation(const std::vector<OffsetRow>& rows, std::string_view key) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const OffsetRow& candidate) { return candidate.candidate.key == key; });
  if (row == rows.end() || !row->offset) return "-";
  const auto& deviation_m = row->offset->standard_deviation_m;
  return metres(row->offset->mean_m) + (deviation_m ? " +- " + metres(*deviation_m) : "");
}

}  // namespace

std::vector<OffsetRow> offset_rows(const std::vector<AttemptOutcome>& outcomes, std::uint64_t seed) {
  std::vector<OffsetRow> rows;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!outcomes.front().at(i)) continue;
    OffsetRow row{candidates.at(i), outcomes.size(), 0, std::nullopt, {}, std::nullopt, std::nullopt};
    std::vector<double> offsets_m;
    for (const AttemptOutcome& outcome : outcomes) {
      const DriveOutcome& drive = *outcome.at(i);
      if (drive.end) {
        offsets_m.push_back(std::hypot(drive.end->x_m, drive.end->y_m));
        if (const auto inside = inside_ellipse95(drive))
          row.inside_ellipse95 = row.inside_ellipse95.value_or(0) + (*inside ? 1 : 0);
      } else if (row.first_failure.empty()) {
        row.first_failure = drive.failure;
      }
    }
    row.finished = offsets_m.size();
    if (!offsets_m.empty()) row.offset = offset_statistics(offsets_m, seed);
    if (row.candidate.published) row.met = is_met(row);
    rows.push_back(row);
  }
  return rows;
}

bool all_met(const std::vector<OffsetRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const OffsetRow& row) { return row.met.value_or(true); });
}

void print_offset_table(std::ostream& out, const std::vector<OffsetRow>& rows,
                        const std::vector<OffsetRow>& of_one_calibration) {
  const auto line = [&](const std::string& title, const std::string& mean, const std::string& deviation,
                        const std::string& published, const std::string& met, const std::string& inside,
                        const std::string& once) {
    out << std::left << std::setw(29) << title << std::setw(23) << mean << std::setw(23) << deviation
        << std::setw(17) << published << std::setw(6) << met << std::setw(once.empty() ? 0 : 19) << inside
        << once << "\n";
  };
  line("model", "mean offset [m]", "std. deviation [m]", "published [m]", "met", "in 95 % ellipse",
       of_one_calibration.empty() ? "" : "one calibration [m]");
  for (const OffsetRow& row : rows) {
    const std::string mean = row.offset ? with_interval(row.offset->mean_m, row.offset->mean_ci95_m) : "-";
    const std::string deviation =
        row.offset ? with_interval(row.offset->standard_deviation_m, row.offset->standard_deviation_ci95_m)
                   : "-";
    line(std::string(row.candidate.title), mean, deviation, published_text(row),
         !row.met ? "-" : (*row.met ? "yes" : "no"),
         row.inside_ellipse95 ? std::to_string(*row.inside_ellipse95) + " of " + std::to_string(row.finished)
                              : "-",
         of_one_calibration.empty() ? "" : mean_and_deviation(of_one_calibration, row.candidate.key));
  }
  for (const OffsetRow& row : rows) {
    if (row.finished == row.attempts) continue;
    out << row.candidate.title << ": only " << row.finished << " of " << row.attempts
        << " attempts came to their end; the first that did not: " << row.first_failure << "\n";
  }
}

ordered_json offset_json(const std::vector<OffsetRow>& rows) {
  ordered_json models = ordered_json::object();
  for (const OffsetRow& row : rows) {
    ordered_json model{{"attempts", row.attempts}, {"finished", row.finished}};
    if (row.offset) {
      const OffsetStatistics& offset = *row.offset;
      model["mean_offset"] = to_json(offset.mean_m, offset.mean_ci95_m);
      if (offset.standard_deviation_m) {
        model["standard_deviation"] = to_json(*offset.standard_deviation_m, offset.standard_deviation_ci95_m);
      }
    }
    if (row.inside_ellipse95) model["inside_ellipse95"] = *row.inside_ellipse95;
    if (!row.first_failure.empty()) model["first_failure"] = row.first_failure;
    if (row.candidate.published) {
      model["published"] = {{"mean_offset_m", row.candidate.published->mean_m},
                            {"standard_deviation_m", row.candidate.published->standard_deviation_m}};
      model["met"] = *row.met;
    }
    models[std::string(row.candidate.key)] = std::move(model);
  }
  return models;
}

}  // namespace wheelwright::tools
