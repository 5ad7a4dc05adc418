#include "model/gap/simulation_gap.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/conclusion/linear_verdict.hpp"
#include "model/gap/pose_fit.hpp"
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
  const bool is_named =
      simulation.verdict == Verdict::named || simulation.verdict == Verdict::nothing_missing;
  if (is_named && !simulation.check.passed && !simulation.check.statistics.empty())
    remarks.push_back("What was found of the simulation does not explain all of its runs: " +
                      simulation.check.statistics.front().sentence + ".");
  return remarks;
}

// Near enough to each other to show how the robot answers.
bool has_dense_poses(const DriveLog& log) {
  constexpr double apart_s = 0.2;
  const auto poses = std::ranges::count_if(
      log.samples, [](const DriveSample& sample) { return sample.reference_pose().has_value(); });
  const double duration_s = log.samples.back().t_s - log.samples.front().t_s;
  return static_cast<double>(poses) * apart_s >= duration_s;
}

DriveLog without_counts(DriveLog log) {
  for (DriveSample& sample : log.samples) {
    sample.ticks.reset();
    sample.gyro_z_rad_s.reset();
  }
  return log;
}

std::vector<DriveLog> all_without_counts(std::span<const DriveLog> logs) {
  std::vector<DriveLog> result;
  for (const DriveLog& log : logs) result.push_back(without_counts(log));
  return result;
}

bool is_gain(const LinearChange& change) {
  return change.what == "gain";
}

// An effect that stands between counts and poses is a gain of the wheels to poses alone.
bool is_geometry(const std::string& effect) {
  const EffectInfo* info = find_effect(effect);
  return info != nullptr && info->needs.encoders && info->needs.reference;
}

// A simulation that shows poses alone does not tell a gain of its wheels from a scale of the floor, nor a lag
// of turns from one of a wheel, as counts of the robot do. Whether there is a difference at all, the robot's
// poses show: without one by them, there is none of that kind.
void leave_out_unlike_channels(GapAnalysis& robot, const GapAnalysis& by_poses) {
  const auto& changes = by_poses.linear_changes;
  const bool gain_differs = std::ranges::any_of(changes, is_gain);
  const bool timing_differs = !std::ranges::all_of(changes, is_gain);
  const bool geometry_differs = gain_differs && std::ranges::any_of(robot.differing_effects, is_geometry);
  std::erase_if(robot.linear_changes, [&](const LinearChange& change) {
    return is_gain(change) ? !gain_differs || geometry_differs : !timing_differs;
  });
  if (!gain_differs) std::erase_if(robot.differing_effects, is_geometry);
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
    words += "The linear part of the robot, beside that of the simulation: " +
             in_words(robot.linear_changes, "the simulation") + ".";
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

std::string in_floors(const Excess& excess) {
  std::ostringstream text;
  text << std::setprecision(2) << excess.times << " times as far off in " << excess.figure
       << " as noise explains";
  return text.str();
}

}  // namespace

void hold_against_simulator(SimulationGap& gap, const Score& train, const Score& test) {
  constexpr double as_near_as_noise = 1.15;
  GapAnalysis& robot = gap.robot;
  const bool says_nothing = robot.verdict == Verdict::nothing_missing;
  if (!says_nothing && robot.verdict != Verdict::named && robot.verdict != Verdict::unnamed) return;
  const Excess excess = largest_excess({robot.train.before, train, robot.train.floor},
                                       {robot.test.before, test, robot.test.floor});
  if (says_nothing && excess.times >= more_than_noise) {
    robot.verdict = Verdict::unnamed;
    robot.summary = "No effect differs, and yet the simulator itself is " + in_floors(excess) +
                    ": something differs that has no name here.";
    for (const std::string& remark : gap.remarks) robot.summary += " " + remark;
  } else if (!says_nothing && excess.times < as_near_as_noise) {
    robot.summary +=
        " The simulator itself is as near to these runs as noise allows: what differs hardly shows in them.";
  }
}

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
  const bool differs = !robot->linear_changes.empty() || !robot->differing_effects.empty();
  if (differs && hold_poses_alone(simulated) && !hold_poses_alone(train) &&
      std::ranges::all_of(train, has_dense_poses) && std::ranges::all_of(test, has_dense_poses)) {
    const auto by_poses =
        analyse_gap(all_without_counts(train), all_without_counts(test), options, parallel_for, second_half);
    if (by_poses) leave_out_unlike_channels(*robot, *by_poses);
  }
  SimulationGap result{*std::move(robot), *std::move(simulation), {}, {}};
  result.differences = effect_differences(result.simulation, result.robot);
  std::erase_if(result.differences,
                [](const EffectDifference& difference) { return difference.effect == delay_effect; });
  result.remarks = remarks_on(result.simulation, simulated, train.front());
  conclude(result);
  return result;
}

}  // namespace wheelwright::gap
