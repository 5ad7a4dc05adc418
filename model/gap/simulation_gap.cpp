#include "model/gap/simulation_gap.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/gap/conclusion/linear_verdict.hpp"
#include "model/log/near_periods.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::string_view delay_effect = "transport_delay";

// The delay is a part of the linear model, so that it is compared as one.
RobotModel model_of(const GapAnalysis& simulation) {
  RobotModel model = simulation.after;
  std::erase_if(model.effects, [](const AddedEffect& effect) { return effect.setting.name == delay_effect; });
  model.linear_part = simulation.search.final.model.with_delay_in_linear_part().linear();
  return model;
}

bool have_the_same_commands(const DriveLog& one, const DriveLog& other) {
  return std::ranges::equal(one.samples, other.samples, [](const DriveSample& a, const DriveSample& b) {
    return a.t_s == b.t_s && a.command_m_s.left == b.command_m_s.left &&
           a.command_m_s.right == b.command_m_s.right;
  });
}

std::optional<double> apart_m(const DriveSample& one, const DriveSample& other) {
  if (!one.reference_x_m || !one.reference_y_m || !other.reference_x_m || !other.reference_y_m)
    return std::nullopt;
  return std::hypot(*one.reference_x_m - *other.reference_x_m, *one.reference_y_m - *other.reference_y_m);
}

// A simulator whose noise differs from run to run.
std::optional<std::string> random_runs(std::span<const DriveLog> simulated) {
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!have_the_same_commands(simulated[i], simulated[j])) continue;
      const auto apart = apart_m(simulated[i].samples.back(), simulated[j].samples.back());
      if (!apart || *apart == 0.0) continue;
      std::ostringstream text;
      text << "The simulation is random: " << simulated[i].name << " and " << simulated[j].name
           << " have the same commands and end " << *apart << " m apart.";
      return text.str();
    }
  }
  return std::nullopt;
}

std::optional<std::string> other_wheel_base(const DriveLog& simulated, const DriveLog& real) {
  constexpr double same_m = 1e-6;
  if (std::abs(simulated.wheel_base_m - real.wheel_base_m) <= same_m) return std::nullopt;
  std::ostringstream text;
  text << "Its wheel base is given as " << simulated.wheel_base_m << " m, and that of the robot as "
       << real.wheel_base_m << " m.";
  return text.str();
}

std::vector<std::string> remarks_on(const GapAnalysis& simulation, std::span<const DriveLog> simulated,
                                    const DriveLog& real) {
  std::vector<std::string> remarks;
  if (auto random = random_runs(simulated)) remarks.push_back(*std::move(random));
  if (auto base = other_wheel_base(simulated.front(), real)) remarks.push_back(*std::move(base));
  if (simulation.verdict == Verdict::unnamed)
    remarks.push_back("The simulation itself does something that has no name here: " + simulation.summary);
  if (simulation.verdict == Verdict::ambiguous)
    remarks.push_back("Its own runs leave a doubt about the simulation: " + simulation.summary);
  return remarks;
}

bool is_gap(const EffectDifference& difference) {
  return difference.kind == DifferenceKind::missing || difference.kind == DifferenceKind::wrong_size ||
         difference.kind == DifferenceKind::surplus;
}

// Verdict and summary of the robot's analysis become those on the simulation.
void conclude(SimulationGap& gap) {
  GapAnalysis& robot = gap.robot;
  std::erase_if(robot.found, [&](const Finding& found) {
    const auto difference = std::ranges::find(gap.differences, found.setting.name, &EffectDifference::effect);
    return difference == gap.differences.end() || !is_gap(*difference);
  });
  std::string words = in_words(gap.differences);
  if (!robot.linear_changes.empty()) {
    words += (words.empty() ? "" : " ");
    words +=
        "The linear part of the robot, beside that of the simulation: " + in_words(robot.linear_changes) +
        ".";
    if (auto delay = delay_finding(robot.linear_changes, robot.linear_gain_nats))
      robot.found.push_back(*std::move(delay));
  }
  const bool by_effects = std::ranges::any_of(gap.differences, is_gap) || !robot.found.empty();
  if (robot.verdict == Verdict::named || robot.verdict == Verdict::nothing_missing) {
    robot.verdict = by_effects                      ? Verdict::named
                    : !robot.linear_changes.empty() ? Verdict::unnamed
                                                    : Verdict::nothing_missing;
    robot.summary = words.empty() ? "The simulation does what these runs show of the robot." : words;
    if (!robot.check.passed && by_effects)
      robot.summary += " And something else: " + robot.check.statistics.front().sentence + ".";
  } else if (!words.empty()) {
    robot.summary += " Of the simulation: " + words;
  }
  for (const std::string& remark : gap.remarks) robot.summary += " " + remark;
}

}  // namespace

tl::expected<SimulationGap, GapRefusal> analyse_simulation_gap(std::span<const DriveLog> simulated,
                                                               std::span<const DriveLog> train,
                                                               std::span<const DriveLog> test,
                                                               const ParallelFor& parallel_for,
                                                               const Progress& progress) {
  GapOptions options;
  options.period_s = shortest_period_s(train);
  const auto first_half = [&](const std::string& what, double share) {
    progress("simulation: " + what, 0.5 * share);
  };
  const auto second_half = [&](const std::string& what, double share) {
    progress("robot: " + what, 0.5 + 0.5 * share);
  };
  GapOptions of_simulation = options;
  of_simulation.names_small_effects = true;
  auto simulation = analyse_gap(simulated, {}, of_simulation, parallel_for, first_half);
  if (!simulation) return tl::unexpected(simulation.error());
  if (simulation->verdict == Verdict::bad_data || simulation->verdict == Verdict::not_testable)
    return tl::unexpected(
        GapRefusal{simulated.front().name + ": the runs of the simulation: " + simulation->summary});
  options.simulation = model_of(*simulation);
  auto robot = analyse_gap(train, test, options, parallel_for, second_half);
  if (!robot) return tl::unexpected(robot.error());
  SimulationGap result{*std::move(robot), *std::move(simulation), {}, {}};
  result.differences = effect_differences(result.simulation, result.robot);
  std::erase_if(result.differences,
                [](const EffectDifference& difference) { return difference.effect == delay_effect; });
  result.remarks = remarks_on(result.simulation, simulated, train.front());
  conclude(result);
  return result;
}

}  // namespace wheelwright::gap
