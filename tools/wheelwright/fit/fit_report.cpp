#include "tools/wheelwright/fit/fit_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <utility>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/fit/fit_arma.hpp"
#include "tools/wheelwright/fit/fit_fir.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

constexpr std::size_t longest_table = 16;  // commands

void add_speeds(FitReport& report, const FirFit& fit) {
  report.speeds = steady_state_speeds(report.runs, fit.model, fit.left, fit.right);
  report.hole = find_command_hole(report.speeds);
  report.curve = find_speed_curve(report.hole ? without_hole(report.speeds, *report.hole) : report.speeds);
}

void print_holes(std::ostream& out, const std::vector<DriveLog>& runs) {
  bool any = false;
  for (const auto& run : runs) {
    for (const auto& line : describe_holes(run)) {
      out << "  " << line << "\n";
      any = true;
    }
  }
  if (!any) return;
  out << "  what was commanded there is not known: the runs were cut there, and what follows was left out\n"
         "  until the wheels had forgotten it\n";
}

void print_speed(std::ostream& out, const SteadyStateSpeed* speed) {
  if (speed == nullptr) {
    out << std::setw(18) << "-" << std::setw(7) << "-";
    return;
  }
  out << std::setw(8) << fixed_number(speed->speed_m_s, 4) << " +- "
      << fixed_number(speed->standard_error_m_s, 4) << std::setw(7)
      << fixed_number(speed->speed_m_s / speed->command_m_s, 2);
}

const SteadyStateSpeed* find_speed(const std::vector<SteadyStateSpeed>& speeds, double command_m_s) {
  const auto found = std::ranges::find_if(speeds, [&](const SteadyStateSpeed& speed) {
    return std::abs(speed.command_m_s - command_m_s) < 1e-4;
  });
  return found == speeds.end() ? nullptr : &*found;
}

void print_speeds(std::ostream& out, const SteadyStateSpeeds& speeds) {
  std::vector<double> commands;
  for (const auto* wheel : {&speeds.left, &speeds.right}) {
    for (const auto& speed : *wheel) {
      const auto same = [&](double other) { return std::abs(other - speed.command_m_s) < 1e-4; };
      if (std::ranges::none_of(commands, same)) commands.push_back(speed.command_m_s);
    }
  }
  if (commands.size() > longest_table) return;
  std::ranges::sort(commands);
  out << "\n  command    left wheel settles at       right wheel settles at\n"
         "    [m/s]             [m/s]    gain             [m/s]    gain\n";
  for (const double command : commands) {
    out << std::setw(9) << fixed_number(command, 3) << "  ";
    print_speed(out, find_speed(speeds.left, command));
    out << "  ";
    print_speed(out, find_speed(speeds.right, command));
    out << "\n";
  }
}

std::string gain_text(const GainAt& gain) {
  return fixed_number(gain.gain, 3) + " +- " + fixed_number(gain.standard_error, 3) + " at " +
         fixed_number(gain.command_m_s, 3) + " m/s";
}

void print_hole(std::ostream& out, const CommandHole& hole) {
  const auto m_s = [](double speed) { return fixed_number(speed, 3); };
  out << "\n  the wheels stand still at commands of " << m_s(hole.from_m_s) << " to " << m_s(hole.to_m_s)
      << " m/s (" << hole.commands << " held commands), though they move at " << m_s(hole.moves_below_m_s)
      << " and at " << m_s(hole.moves_above_m_s)
      << " m/s\n  no linear model has such a hole, and no effect of the library: keep commands out of it\n";
}

void print_curve(std::ostream& out, const SteadyStateSpeeds& speeds, const SpeedCurve& curve) {
  if (!curve.bend && !curve.steps) return;
  print_speeds(out, speeds);
  out << "\n";
  if (const auto& bend = curve.bend) {
    out << "  the curve from command to speed is "
        << (bend->low.gain > bend->high.gain ? "concave" : "convex") << ": gain " << gain_text(bend->low)
        << ", " << gain_text(bend->high) << "\n";
  }
  if (const auto& steps = curve.steps) {
    out << "  speeds go in steps of " << fixed_number(1000.0 * steps->step_m_s, 1) << " mm/s of command ("
        << fixed_number(1000.0 * steps->smallest_m_s, 1) << " to "
        << fixed_number(1000.0 * steps->largest_m_s, 1) << "); a smooth curve scatters like this with p "
        << (steps->p_value < 1e-6 ? std::string("< 0.000001") : "= " + fixed_number(steps->p_value, 6))
        << "\n";
  }
  out << "  a linear model has neither; wheelwright gap can add what is missing\n";
}

}  // namespace

const LinearModel& FitReport::model() const {
  if (const auto* fir = std::get_if<FirReport>(&fit)) return fir->fit.model;
  return std::get<ArmaFit>(fit).model;
}

const WheelFit& FitReport::left() const {
  if (const auto* fir = std::get_if<FirReport>(&fit)) return fir->fit.left;
  return std::get<ArmaFit>(fit).left.quality;
}

const WheelFit& FitReport::right() const {
  if (const auto* fir = std::get_if<FirReport>(&fit)) return fir->fit.right;
  return std::get<ArmaFit>(fit).right.quality;
}

FitReport report_of(FirFit fit, std::vector<DriveLog> runs) {
  FitReport report{FirReport{std::move(fit), {}}, std::move(runs), {}, {}, {}};
  auto& fir = std::get<FirReport>(report.fit);
  fir.score = score_of_fir_fit(fir.fit, report.runs);
  add_speeds(report, fir.fit);
  return report;
}

FitReport report_of(ArmaFit fit, std::vector<DriveLog> runs) {
  FitReport report{std::move(fit), std::move(runs), {}, {}, {}};
  // A recursion that runs into what no linear model holds forgets so slowly that it hides settled speeds.
  if (const auto moving_average = fit_fir(report.runs)) add_speeds(report, *moving_average);
  return report;
}

void print_fit(std::ostream& out, const FitReport& report) {
  if (const auto* fir = std::get_if<FirReport>(&report.fit)) {
    print_fir_fit(out, fir->fit, report.runs.size(), fir->score);
  } else {
    print_arma_fit(out, std::get<ArmaFit>(report.fit), report.runs.size());
  }
  print_holes(out, report.runs);
  if (report.hole) print_hole(out, *report.hole);
  print_curve(out, report.speeds, report.curve);
}

}  // namespace wheelwright::tools
