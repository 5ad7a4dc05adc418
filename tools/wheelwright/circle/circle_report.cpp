#include "tools/wheelwright/circle/circle_report.hpp"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <ostream>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

bool is_name_of(const std::string& effect, const Imperfection& imperfection) {
  return std::ranges::find(imperfection.effects, effect) != imperfection.effects.end();
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

void print_laps(std::ostream& out, const std::string& title, const Laps& laps) {
  out << title;
  if (laps.offsets_m.empty()) {
    out << "did not come to its end: " << laps.failure << "\n";
    return;
  }
  const auto count = static_cast<double>(laps.offsets_m.size());
  const double mean = std::accumulate(laps.offsets_m.begin(), laps.offsets_m.end(), 0.0) / count;
  const auto [least, most] = std::ranges::minmax(laps.offsets_m);
  out << fixed_number(mean, 3) << " m, mean of " << laps.offsets_m.size() << " drives ("
      << fixed_number(least, 3) << " to " << fixed_number(most, 3) << ")";
  if (!laps.failure.empty()) out << "; another did not come to its end: " << laps.failure;
  out << "\n";
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
  out << "the gap workflow:               " << report.verdict
      << (report.named.empty() ? "" : ": " + joined(report.named, ", ")) << "\n";
  print_laps(out, "B, with what the workflow added: ", report.after);
  out << "\nopened: " << report.sealed_file << "\n";
  for (const auto& imperfection : report.hidden) {
    out << "  hidden: " << imperfection.what << " (rightly named " << joined(imperfection.effects, " or ")
        << ")\n";
  }
  const Told result = told(report);
  out << "  named rightly: " << result.rightly << " of " << report.hidden.size()
      << ", names that belong to nothing hidden: " << result.falsely << "\n";
}

}  // namespace wheelwright::tools
