#include "tools/wheelwright/gap/gap_text.hpp"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <span>
#include <string_view>

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"
#include "model/gap/runs/short_name.hpp"
#include "tools/wheelwright/gap/check_section.hpp"
#include "tools/wheelwright/page/number_text.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

void print_finding(std::ostream& out, const gap::Finding& found) {
  const EffectInfo* info = find_effect(found.setting.name);
  out << "  " << found.setting.name
      << (found.setting.variant.empty() ? "" : " (" + found.setting.variant + ")") << ": "
      << (info != nullptr ? info->summary : "") << "\n";
  const auto parameters = parameters_of(found.setting);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    out << "    " << std::left << std::setw(16) << parameters[i].name << " "
        << short_number(found.setting.parameters[i]);
    if (i < found.intervals.size()) {
      out << "  [" << short_number(found.intervals[i].lower) << ", " << short_number(found.intervals[i].upper)
          << "]";
    }
    out << (parameters[i].unit == "1" ? "" : " " + parameters[i].unit) << "\n";
  }
  out << "    log likelihood of held-out runs higher by " << fixed_number(found.heldout_gain_nats, 1)
      << "; probability " << (found.posterior < 0.0005 ? "below 0.001" : fixed_number(found.posterior, 3));
  for (std::size_t i = 0; i < found.rivals.size() && i < 2; ++i) {
    if (found.rivals[i].posterior > 0.001) {
      out << ", " << found.rivals[i].effect << " " << fixed_number(found.rivals[i].posterior, 3);
    }
  }
  out << "\n";
}

void print_row(std::ostream& out, const std::string& name, const std::optional<double>& before,
               const std::optional<double>& after, const std::optional<double>& floor) {
  constexpr double much_larger = 1.1;
  if (!before || !after) return;
  out << "  " << std::left << std::setw(40) << name << std::right << std::setw(10)
      << fixed_number(1000.0 * *before, 2) << std::setw(10) << fixed_number(1000.0 * *after, 2)
      << std::setw(10) << (floor ? fixed_number(1000.0 * *floor, 2) : "-")
      << (*after > much_larger * *before ? "  worse than before" : "") << "\n";
}

void print_figures(std::ostream& out, const std::string& runs, const gap::GapFigures& figures) {
  const auto value = [](const std::optional<AtHorizon>& figure) -> std::optional<double> {
    return figure ? std::optional(figure->value) : std::nullopt;
  };
  const auto horizon = [](const std::optional<AtHorizon>& figure) {
    return figure ? fixed_number(figure->horizon_s, 0) + " s" : std::string();
  };
  const auto& [before, after, floor] = figures;
  print_row(out, runs + ": wheel speed, mm/s RMS", before.wheel_speed_rms_m_s, after.wheel_speed_rms_m_s,
            floor.wheel_speed_rms_m_s);
  print_row(out, runs + ": wheel travel, mm RMS", before.distance_rms_m, after.distance_rms_m,
            floor.distance_rms_m);
  print_row(out, runs + ": position after " + horizon(before.position_rms_m) + ", mm RMS",
            value(before.position_rms_m), value(after.position_rms_m), value(floor.position_rms_m));
  print_row(out, runs + ": heading after " + horizon(before.heading_rms_rad) + ", mrad RMS",
            value(before.heading_rms_rad), value(after.heading_rms_rad), value(floor.heading_rms_rad));
}

void print_faults(std::ostream& out, const std::string& title, const std::vector<gap::DataFault>& all,
                  bool happened) {
  constexpr std::size_t most = 8;
  std::size_t count = 0;
  for (const auto& fault : all) {
    if (fault.happened != happened) continue;
    if (count == 0) out << "\n" << title << ":\n";
    if (++count <= most) out << "  " << fault.log << ":" << fault.row << ": " << fault.text() << "\n";
  }
  if (count > most) out << "  and " << count - most << " more, all in gap.json\n";
}

std::string names_text(std::span<const std::string> runs) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < runs.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + runs[i];
  if (runs.size() > most) text += " and " + std::to_string(runs.size() - most) + " more";
  return text;
}

}  // namespace

std::string run_roles_text(const gap::GapAnalysis& analysis) {
  std::vector<std::string_view> names;
  for (const auto* runs : {&analysis.trained, &analysis.held_out, &analysis.tested}) {
    names.insert(names.end(), runs->begin(), runs->end());
  }
  const std::vector<std::string> shortened = gap::short_names(names);
  const std::span all(shortened);
  const std::size_t trained = analysis.trained.size();
  const std::size_t held_out = analysis.held_out.size();
  std::string text = "training: " + names_text(all.first(trained));
  text += analysis.tail_held_out ? "; held out: its last third"
          : held_out == 0        ? ""
                                 : "; held out: " + names_text(all.subspan(trained, held_out));
  if (analysis.untouched) text += "; untouched: " + names_text(all.subspan(trained + held_out));
  return text;
}

void print_gap(std::ostream& out, const gap::GapAnalysis& analysis) {
  out << gap::verdict_name(analysis.verdict) << ": " << analysis.summary << "\n";
  print_faults(out, "data faults", analysis.data_faults, false);
  print_faults(out, "what held a wheel", analysis.data_faults, true);
  if (!analysis.found.empty()) out << "\nwhat is missing:\n";
  for (const auto& found : analysis.found) print_finding(out, found);
  if (!analysis.where.empty()) {
    out << "\nwhere the linear model is wrong" << (analysis.found.empty() ? "" : ", without what is missing")
        << ":\n";
  }
  for (const auto& regime : analysis.where) {
    out << "  " << std::left << std::setw(39) << regime.name << " " << percent(regime.share_of_gap)
        << " of the gap in " << percent(regime.share_of_time) << " of the time\n";
  }
  if (analysis.train.before.empty() && analysis.test.before.empty()) return;
  out << "\nruns: " << run_roles_text(analysis) << "\n";
  out << "\nthe gap                                       before     after     floor\n";
  print_figures(out, "training", analysis.train);
  print_figures(out, test_runs_text(analysis), analysis.test);
  if (const std::string late = late_references_text(analysis); !late.empty()) out << "  " << late << "\n";
  if (const std::string check = check_text(analysis); !check.empty()) out << "  " << check << "\n";
  if (!analysis.not_testable.empty()) out << "\nthese runs cannot show:\n";
  for (const auto& effect : analysis.not_testable) out << "  " << effect.effect << ": " << effect.why << "\n";
}

std::string late_references_text(const gap::GapAnalysis& analysis) {
  constexpr double min_s = 0.002;
  const double late_s = analysis.search.final.model.reference_lag_s();
  if (std::abs(late_s) < min_s) return "";
  const bool by_gyro = analysis.search.final.model.shape.gyro_scaled;
  return std::string(by_gyro ? "The gyro shows" : "Reference poses show") + " the robot " +
         fixed_number(1000.0 * std::abs(late_s), 0) + " ms " + (late_s > 0.0 ? "later" : "earlier") +
         " than the counts do, which the figures allow for.";
}

std::string experiment_text(const gap::NextExperiment& next) {
  const auto named = [](const std::string& name) { return name == "nothing" ? "nothing missing" : name; };
  std::string text = "Drive " + next.manoeuvre + " (" + fixed_number(next.seconds, 0) + " s): it separates " +
                     named(next.separates[0]) + " from " + named(next.separates[1]) +
                     " (expected log-likelihood gain " + fixed_number(next.nats, 0) + ")";
  if (next.makes_testable.size() > 1) {
    text += ", and makes testable:";
    for (const auto& name : next.makes_testable) text += " " + name;
  }
  return text + ".";
}

}  // namespace wheelwright::tools
