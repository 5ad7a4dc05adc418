#include "tools/wheelwright/circle/circle_report.hpp"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>

#include "config/load/text_format.hpp"

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
  if (!laps.failure.empty()) out << "; another did not come to its end: " << laps.failure;
  out << "\n";
}

void print_proof(std::ostream& out, const Proof& proof) {
  out << "each on more drives of its own: ";
  if (!proof.calibrated_m || !proof.found_m) {
    out << (proof.failure.empty() ? "no reference position" : "none came to its end: " + proof.failure)
        << "; the calibrated model drives\n";
    return;
  }
  out << "calibrated " << fixed_number(1e3 * *proof.calibrated_m, 1) << " mm off, found "
      << fixed_number(1e3 * *proof.found_m, 1) << " mm; the " << (proof.is_better() ? "found" : "calibrated")
      << " model drives\n";
}

ordered_json to_json(const Proof& proof) {
  ordered_json json{{"calibrated_m", nullptr}, {"found_m", nullptr}, {"drives", "calibrated"}};
  if (proof.calibrated_m) json["calibrated_m"] = *proof.calibrated_m;
  if (proof.found_m) json["found_m"] = *proof.found_m;
  if (proof.is_better()) json["drives"] = "found";
  return json;
}

ordered_json to_json(const Laps& laps) {
  ordered_json json{{"offsets_m", laps.offsets_m}, {"mean_offset_m", nullptr}, {"failure", nullptr}};
  if (!laps.offsets_m.empty()) json["mean_offset_m"] = mean_m(laps.offsets_m);
  if (!laps.failure.empty()) json["failure"] = laps.failure;
  return json;
}

}  // namespace

Told told(const CircleReport& report) {
  Told told;
  for (const auto& imperfection : report.hidden) {
    told.rightly += std::ranges::any_of(
        report.named, [&](const std::string& effect) { return is_name_of(effect, imperfection); });
  }
  for (const auto& effect : report.named) {
    told.falsely += std::ranges::none_of(
        report.hidden, [&](const Imperfection& imperfection) { return is_name_of(effect, imperfection); });
  }
  return told;
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
  const Told result = told(report);
  out << "  named rightly: " << result.rightly << " of " << report.hidden.size()
      << ", names that belong to nothing hidden: " << result.falsely << "\n";
}

ordered_json circle_json(const CircleReport& report) {
  auto hidden = ordered_json::array();
  for (const auto& imperfection : report.hidden) {
    hidden.push_back({{"what", imperfection.what}, {"effects", imperfection.effects}});
  }
  auto experiments = ordered_json::array();
  for (const Experiment& experiment : report.experiments) {
    experiments.push_back({{"manoeuvre", experiment.manoeuvre},
                           {"seconds", experiment.seconds},
                           {"separates", experiment.separates},
                           {"failure", nullptr}});
    if (!experiment.failure.empty()) experiments.back()["failure"] = experiment.failure;
  }
  const Told result = told(report);
  return {{"before", to_json(report.before)},
          {"experiments", experiments},
          {"verdict", report.verdict},
          {"named", report.named},
          {"proof", to_json(report.proof)},
          {"after", to_json(report.after)},
          {"hidden", hidden},
          {"sealed_file", report.sealed_file},
          {"named_rightly", result.rightly},
          {"named_falsely", result.falsely}};
}

}  // namespace wheelwright::tools
