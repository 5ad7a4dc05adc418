#include "tools/wheelwright/circle/circle_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using nlohmann::ordered_json;

bool is_name_of(const std::string& effect, const Imperfection& imperfection) {
  return std::ranges::find(imperfection.effects, effect) != imperfection.effects.end();
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

double mean_m(const std::vector<double>& offsets_m) {
  const auto count = static_cast<double>(offsets_m.size());
  return std::accumulate(offsets_m.begin(), offsets_m.end(), 0.0) / count;
}

void print_laps(std::ostream& out, const std::string& title, const Laps& laps) {
  out << title;
  if (laps.offsets_m.empty()) {
    out << "did not come to its end: " << laps.failure << "\n";
    return;
  }
  const auto [least, most] = std::ranges::minmax(laps.offsets_m);
  out << fixed_number(mean_m(laps.offsets_m), 3) << " m, mean of " << laps.offsets_m.size() << " drives ("
      << fixed_number(least, 3) << " to " << fixed_number(most, 3) << ")";
  if (laps.stopped > 0) out << "; " << laps.stopped << " did not come to an end: " << laps.failure;
  out << "\n";
}

void print_own_drives(std::ostream& out, const OwnDrives& drives) {
  if (drives.error_m) out << fixed_number(1e3 * *drives.error_m, 1) << " mm off";
  if (drives.error_m && drives.stopped > 0) out << ", ";
  if (drives.stopped > 0) out << drives.stopped << " stopped (" << drives.failure << ")";
  if (!drives.error_m && drives.stopped == 0) out << "no reference position";
}

void print_proof(std::ostream& out, const Proof& proof) {
  out << "each on more drives of its own: calibrated ";
  print_own_drives(out, proof.calibrated);
  out << "; found ";
  print_own_drives(out, proof.found);
  out << "; the " << (proof.is_better() ? "found" : "calibrated") << " model drives\n";
}

ordered_json to_json(const Proof& proof) {
  ordered_json json{{"calibrated_m", nullptr},
                    {"found_m", nullptr},
                    {"calibrated_stopped", proof.calibrated.stopped},
                    {"found_stopped", proof.found.stopped},
                    {"drives", "calibrated"}};
  if (proof.calibrated.error_m) json["calibrated_m"] = *proof.calibrated.error_m;
  if (proof.found.error_m) json["found_m"] = *proof.found.error_m;
  if (proof.is_better()) json["drives"] = "found";
  return json;
}

ordered_json to_json(const Laps& laps) {
  ordered_json json{{"offsets_m", laps.offsets_m},
                    {"mean_offset_m", nullptr},
                    {"stopped", laps.stopped},
                    {"failure", nullptr}};
  if (!laps.offsets_m.empty()) json["mean_offset_m"] = mean_m(laps.offsets_m);
  if (!laps.failure.empty()) json["failure"] = laps.failure;
  return json;
}

bool belongs_to_any(const std::string& effect, const std::vector<Imperfection>& imperfections) {
  return std::ranges::any_of(
      imperfections, [&](const Imperfection& imperfection) { return is_name_of(effect, imperfection); });
}

ordered_json to_json(const std::vector<Imperfection>& imperfections) {
  auto json = ordered_json::array();
  for (const auto& imperfection : imperfections)
    json.push_back({{"what", imperfection.what}, {"effects", imperfection.effects}});
  return json;
}

}  // namespace

std::optional<Imperfection> scale_error(double calibrated_m, double true_m) {
  const std::string effect = "distance_scale";
  const double error = calibrated_m / true_m - 1.0;
  if (std::abs(error) < find_effect(effect)->parameters.front().negligible) return std::nullopt;
  return Imperfection{"metres per tick, calibrated " + fixed_number(100.0 * std::abs(error), 2) + " % too " +
                          (error > 0.0 ? "large" : "small"),
                      {effect}};
}

NamingScore naming_score(const CircleReport& report) {
  NamingScore score;
  for (const auto& imperfection : report.hidden) {
    score.right += std::ranges::any_of(
        report.named, [&](const std::string& effect) { return is_name_of(effect, imperfection); });
  }
  for (const auto& effect : report.named) {
    score.wrong += !belongs_to_any(effect, report.hidden) && !belongs_to_any(effect, report.not_hidden);
  }
  return score;
}

void print_circle(std::ostream& out, const CircleReport& report) {
  print_laps(out, "A, by the calibrated model:     ", report.before);
  for (const Experiment& experiment : report.experiments) {
    out << "driven to decide:               " << experiment.manoeuvre << ", "
        << fixed_number(experiment.seconds, 0) << " s, for " << joined(experiment.separates, " or ")
        << (experiment.failure.empty() ? "" : "; " + experiment.failure) << "\n";
  }
  out << "the gap workflow:               " << report.verdict
      << (report.named.empty() ? "" : ": " + joined(report.named, ", ")) << "\n";
  print_proof(out, report.proof);
  print_laps(
      out,
      report.proof.is_better() ? "B, with what the workflow added: " : "B, by the calibrated model:     ",
      report.after);
  out << "\nopened: " << report.sealed_file << "\n";
  for (const auto& imperfection : report.hidden) {
    out << "  hidden: " << imperfection.what << " (rightly named " << joined(imperfection.effects, " or ")
        << ")\n";
  }
  for (const auto& own : report.not_hidden) {
    out << "  not hidden, but so: " << own.what << " (" << joined(own.effects, " or ") << ")\n";
  }
  const NamingScore score = naming_score(report);
  out << "  named rightly: " << score.right << " of " << report.hidden.size()
      << ", names that belong to nothing hidden: " << score.wrong << "\n";
}

ordered_json circle_json(const CircleReport& report) {
  auto experiments = ordered_json::array();
  for (const Experiment& experiment : report.experiments) {
    experiments.push_back({{"manoeuvre", experiment.manoeuvre},
                           {"seconds", experiment.seconds},
                           {"separates", experiment.separates},
                           {"failure", nullptr}});
    if (!experiment.failure.empty()) experiments.back()["failure"] = experiment.failure;
  }
  const NamingScore score = naming_score(report);
  return {{"before", to_json(report.before)},  {"experiments", experiments},
          {"verdict", report.verdict},         {"named", report.named},
          {"proof", to_json(report.proof)},    {"after", to_json(report.after)},
          {"hidden", to_json(report.hidden)},  {"not_hidden", to_json(report.not_hidden)},
          {"sealed_file", report.sealed_file}, {"named_rightly", score.right},
          {"named_falsely", score.wrong}};
}

}  // namespace wheelwright::tools
