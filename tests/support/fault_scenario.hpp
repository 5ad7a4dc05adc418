// One simulated drive with one fault in it, and what filter and odometry make of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/filter/hybrid_filter.hpp"
#include "model/simulation/odometry.hpp"
#include "tests/support/recorded_drive.hpp"

namespace wheelwright::test {

enum class Injection { drop, freeze, spike, stuck, swap, drift, stall, lift, robot_freeze, robot_spike };
inline constexpr int injection_count = 10;

inline const char* name_of(Injection what) {
  constexpr const char* names[] = {"drop",  "freeze", "spike", "stuck",          "swap",
                                   "drift", "stall",  "lift",  "freeze (robot)", "add counts (robot)"};
  return names[static_cast<int>(what)];
}

// The name that would be right.
inline FaultKind right_name(Injection what) {
  constexpr FaultKind names[] = {
      FaultKind::dropped,  FaultKind::frozen,  FaultKind::spike,  FaultKind::stuck_at, FaultKind::swapped,
      FaultKind::drifting, FaultKind::stalled, FaultKind::lifted, FaultKind::frozen,   FaultKind::spike};
  return names[static_cast<int>(what)];
}

struct FaultPlan {
  Injection what{};
  bool left = true;
  int onset = 0;  // ticks
  int end = 0;
  int counts = 0;        // jump
  double share = 1.0;    // of the counts that are lost; of scale change per second
  bool returns = false;  // the counter is right again afterwards
};

inline constexpr double known_from_s = 38.0;  // the filter has learnt the robot; pose errors start at zero
inline constexpr double scenario_s = 80.0;

inline FaultPlan random_fault(Injection what, std::uint64_t seed) {
  std::mt19937_64 random(seed * 7919 + 13);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto between = [&](double a, double b) { return a + (b - a) * uniform(random); };
  const auto log_between = [&](double a, double b) { return a * std::pow(b / a, uniform(random)); };
  const auto ticks = [](double seconds) { return static_cast<int>(seconds / 0.018); };
  FaultPlan plan;
  plan.what = what;
  plan.left = uniform(random) < 0.5;
  plan.onset = ticks(between(known_from_s + 2.0, known_from_s + 12.0));
  const double sign = uniform(random) < 0.5 ? -1.0 : 1.0;
  plan.counts = static_cast<int>(sign * log_between(15.0, 700.0));
  plan.returns = uniform(random) < 0.5;
  double lasts_s = 0.0;
  switch (what) {
    case Injection::drop:
      if (uniform(random) < 0.5) {
        lasts_s = between(0.1, 0.23);
      } else {
        lasts_s = between(0.7, 5.0);
        plan.share = between(0.2, 0.8);
      }
      break;
    case Injection::spike:
    case Injection::robot_spike:
      lasts_s = 0.018;
      break;
    case Injection::stuck:
      lasts_s = between(1.0, 15.0);
      if (std::abs(plan.counts) < 40) plan.counts = plan.counts < 0 ? -40 : 40;
      break;
    case Injection::swap:
      lasts_s = between(6.0, 25.0);
      break;
    case Injection::drift:
      lasts_s = scenario_s;
      plan.share = sign * log_between(0.002, 0.02);
      break;
    case Injection::stall:
      lasts_s = between(1.0, 4.0);
      break;
    case Injection::freeze:
    case Injection::robot_freeze:
    case Injection::lift:
      lasts_s = between(0.5, 12.0);
      break;
  }
  plan.end = std::min(plan.onset + std::max(1, ticks(lasts_s)), ticks(scenario_s) - 120);
  if (what == Injection::drift) plan.end = ticks(scenario_s);
  return plan;
}

inline bool in_the_robot(Injection what) {
  return what == Injection::stall || what == Injection::lift || what == Injection::robot_freeze ||
         what == Injection::robot_spike;
}

inline DriveHook robot_fault(const FaultPlan& plan) {
  using Kind = simulation::Fault::Kind;
  return [plan](simulation::SimulatedRobot& robot, int tick) {
    if (!in_the_robot(plan.what) || (tick != plan.onset && tick != plan.end)) return;
    simulation::Fault fault{};
    fault.side = plan.left ? simulation::Side::left : simulation::Side::right;
    const bool begins = tick == plan.onset;
    switch (plan.what) {
      case Injection::stall:
        fault.kind = begins ? Kind::stall_wheel : Kind::free_wheel;
        break;
      case Injection::lift:
        fault.kind = begins ? Kind::lift_wheel : Kind::set_down_wheel;
        break;
      case Injection::robot_freeze:
        fault.kind = begins ? Kind::freeze_encoder : Kind::thaw_encoder;
        break;
      default:
        fault.kind = Kind::add_counts;
        if (!begins && !plan.returns) return;
        fault.counts = begins ? plan.counts : -plan.counts;
        break;
    }
    robot.inject(fault);
  };
}

// Puts a fault of the encoder or of its transport into a stream of frames that was sound.
inline void corrupt(std::vector<SensorFrame>& frames, const FaultPlan& plan, std::uint64_t seed) {
  if (in_the_robot(plan.what)) return;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const std::vector<SensorFrame> sound = frames;
  WheelTicks shown = sound[static_cast<std::size_t>(plan.onset) - 1].ticks;
  double scaled = 0.0;
  for (auto k = static_cast<std::size_t>(plan.onset); k < frames.size(); ++k) {
    const bool active = static_cast<int>(k) < plan.end;
    const WheelTicks& before = sound[k - 1].ticks;
    WheelTicks change{sound[k].ticks.left - before.left, sound[k].ticks.right - before.right};
    if (plan.what == Injection::swap && active) std::swap(change.left, change.right);
    auto& moved = plan.left ? change.left : change.right;
    auto& total = plan.left ? shown.left : shown.right;
    const auto& truth = plan.left ? sound[k].ticks.left : sound[k].ticks.right;
    const bool first = static_cast<int>(k) == plan.onset;
    const bool back = static_cast<int>(k) == plan.end && plan.returns;
    switch (plan.what) {
      case Injection::drop: {
        std::int64_t kept = 0;
        for (std::int64_t i = 0; i < std::abs(moved); ++i) kept += uniform(random) >= plan.share ? 1 : 0;
        if (active) moved = moved < 0 ? -kept : kept;
        break;
      }
      case Injection::freeze:
        if (active) moved = 0;
        if (back) moved = truth - total;
        break;
      case Injection::spike:
        if (first) moved += plan.counts;
        if (back) moved = truth - total;
        break;
      case Injection::stuck:
        if (active) moved = first ? plan.counts : 0;
        if (back) moved = truth - total;
        break;
      case Injection::drift: {
        const double since_s = 0.018 * static_cast<double>(static_cast<int>(k) - plan.onset);
        scaled += static_cast<double>(moved) * (1.0 + std::clamp(plan.share * since_s, -0.15, 0.15));
        moved = static_cast<std::int64_t>(std::floor(scaled));
        scaled -= static_cast<double>(moved);
        break;
      }
      default:
        break;
    }
    shown.left += change.left;
    shown.right += change.right;
    frames[k].ticks = shown;
  }
}

struct FaultOutcome {
  FaultPlan plan;
  double harm_m =
      0.0;  // what the fault does to odometry's final pose; to the way driven where it is the robot's
  bool found = false;
  double delay_s = 0.0;
  FaultKind named = FaultKind::none;
  int false_alarms = 0;  // before the fault
  int false_recalibrations = 0;
  double hybrid_error_m = 0.0;  // against the truth, at the end
  double odometry_error_m = 0.0;
  double hybrid_left_m = 0.0;  // hybrid against odometry without the fault: what was not kept out of the pose
  double sound_error_m = 0.0;  // of odometry without the fault, where it is in the stream
};

inline Pose odometry_at_end(const std::vector<SensorFrame>& frames, const RobotModel& model,
                            const Pose& start) {
  Odometry odometry(model.linear_part.wheel_base_m, model.encoder_scale->metres_per_tick);
  const auto known = static_cast<std::size_t>(known_from_s / 0.018);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (k == known) odometry.set_pose(start);
    if (frames[k].after_gap) odometry.rebase();
    if (frames[k].valid) odometry.update(frames[k].ticks);
  }
  return odometry.pose();
}

inline FaultOutcome run_fault(const RobotModel& model, const simulation::SimulationConfig& robot,
                              const FaultPlan& plan, std::uint64_t seed) {
  FaultOutcome outcome;
  outcome.plan = plan;
  RecordedDrive drive = record_drive(robot, seed, scenario_s, robot_fault(plan));
  const auto known = static_cast<std::size_t>(known_from_s / 0.018);
  const Pose start = drive.true_poses[known - 1];
  const Pose& end = drive.true_poses.back();
  const Pose sound = odometry_at_end(drive.frames, model, start);
  outcome.sound_error_m = distance_between_m(sound, end);
  corrupt(drive.frames, plan, seed);
  const Pose odometry = odometry_at_end(drive.frames, model, start);
  outcome.odometry_error_m = distance_between_m(odometry, end);
  outcome.harm_m = distance_between_m(odometry, sound);
  Pose sound_pose = sound;
  if (in_the_robot(plan.what)) {
    const RecordedDrive without = record_drive(robot, seed, scenario_s);
    const bool moves_robot = plan.what == Injection::stall || plan.what == Injection::lift;
    if (moves_robot) {
      outcome.harm_m = distance_between_m(without.true_poses.back(), end);
    } else {
      sound_pose = odometry_at_end(without.frames, model, start);
      outcome.sound_error_m = distance_between_m(sound_pose, without.true_poses.back());
      outcome.harm_m = distance_between_m(odometry, sound_pose);
    }
  }

  HybridFilter filter(model);
  for (std::size_t k = 0; k < drive.frames.size(); ++k) {
    if (k == known) filter.set_pose(start);
    const HybridOutput out = filter.step(drive.frames[k]);
    const int tick = static_cast<int>(k);
    if (out.raised_recalibration) ++outcome.false_recalibrations;
    for (const FaultEvent& event : out.events) {
      if (tick < plan.onset) {
        outcome.false_alarms += event.stage == FaultEvent::Stage::began ? 1 : 0;
        continue;
      }
      if (!outcome.found && event.stage != FaultEvent::Stage::ended) {
        outcome.found = true;
        outcome.delay_s = 0.018 * (tick - plan.onset);
      }
      const bool while_there = tick < plan.end + 110;
      if (event.stage == FaultEvent::Stage::named && while_there) {
        if (outcome.named == FaultKind::none || plan.what == Injection::swap ||
            outcome.named == FaultKind::frozen) {
          outcome.named = event.kind;
        }
      }
    }
  }
  if (outcome.found && outcome.named == FaultKind::none) outcome.named = FaultKind::misfit;
  outcome.hybrid_left_m = distance_between_m(filter.pose(), sound_pose);
  outcome.hybrid_error_m = distance_between_m(filter.pose(), end);
  return outcome;
}

}  // namespace wheelwright::test
