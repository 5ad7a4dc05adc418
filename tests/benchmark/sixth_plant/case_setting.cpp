#include "tests/benchmark/sixth_plant/case_setting.hpp"

#include <algorithm>
#include <numbers>

#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/simulation.hpp"

namespace plants::sixth {

namespace {

constexpr double straight_angle_rad = std::numbers::pi;

template <class Item>
Item one_of(const std::vector<Item>& items, Random& random) {
  return items[static_cast<std::size_t>(random.integer(0, static_cast<int>(items.size()) - 1))];
}

Details drawn_details(Random& random) {
  Details details;
  details.coin = unit(random);
  details.warming_s = random.uniform(12, 35);
  details.sign = random.sign();
  details.angle_rad = random.uniform(-straight_angle_rad, straight_angle_rad);
  details.patch_shape = random.uniform(0.7, 1.4);
  return details;
}

// Mostly ahead or behind, as people mount a marker.
double drawn_marker_rad(Expected expected, Random& random) {
  if (expected == Expected::not_named) return random.uniform(-0.1, 0.1);
  if (!random.chance(0.75)) return random.uniform(-straight_angle_rad, straight_angle_rad);
  const double ahead_rad = random.chance(0.5) ? 0 : straight_angle_rad;
  return ahead_rad + random.uniform(-0.4, 0.4);
}

void log_faster(Robot& robot, double period_s, double latency_s) {
  robot.period_s = period_s;
  robot.latency_s = std::min(robot.latency_s, latency_s);
}

// What the robot has to have for its effect to show, without the effect.
void prepare(CaseSetting& setting) {
  Robot& robot = setting.robot;
  if (setting.hides(Effect::backlash)) {
    // A wheel that drags leans against the teeth that drive it.
    const double yield_n_s_m = robot.yield_n_s_m();
    robot.drag_n_s_m = 0.22 * yield_n_s_m;
    robot.motor_n_s_m = yield_n_s_m - robot.drag_n_s_m;
  }
  const bool quick = setting.hides(Effect::encoder_dropout) || setting.hides(Effect::wheel_eccentricity) ||
                     setting.hides(Effect::caster_kick);
  if (quick && robot.period_s > 0.03) log_faster(robot, 0.025, 0.026);
  if (setting.hides(Effect::chipped_tooth) && robot.period_s > 0.02) log_faster(robot, 0.02, 0.02);
  // A moment about the middle shows behind soft tyres only.
  if (setting.hides(Effect::turn_scrub) || setting.hides(Effect::yaw_bias))
    robot.creep_n_s_m = std::min(robot.creep_n_s_m, 100.);
}

// Over a carpet the runs are to begin alike, so that all of them cross it.
Pose drawn_start(const Pose* common, Random& random) {
  Pose start;
  if (common == nullptr) {
    start.x_m = random.uniform(-0.4, 0.4);
    start.y_m = random.uniform(-0.4, 0.4);
    start.heading_rad = random.uniform(-straight_angle_rad, straight_angle_rad);
    return start;
  }
  start.x_m = common->x_m + random.uniform(-0.05, 0.05);
  start.y_m = common->y_m + random.uniform(-0.05, 0.05);
  start.heading_rad = common->heading_rad + random.uniform(-0.2, 0.2);
  return start;
}

DriveScript drawn_script(const CaseSetting& setting, std::uint64_t index, const Pose* common) {
  const std::uint64_t seed = setting.plan.seed;
  Random random = warmed_up(mixed_seed(seed, 50 + index));
  const Pose start = drawn_start(common, random);
  const double duration_s = random.uniform(42, 86);
  Hand hand(setting.robot, start, random);
  drive(hand, *setting.plan.programme, duration_s);
  DriveScript script = hand.script();
  script.noise_seed = mixed_seed(seed, 500 + index);
  return script;
}

// Of the left driver, which is the one that can get hot.
double usual_heat(const CaseSetting& setting) {
  const Robot& robot = setting.robot;
  double heat = 0;
  long count = 0;
  for (const DriveScript& script : setting.scripts)
    for (const PerWheel<double>& command_m_s : script.command_m_s) {
      const double left_m_s = command_m_s[left_side];
      heat += left_m_s * left_m_s / robot.top_m_s / robot.top_m_s * robot.gain * robot.gain;
      ++count;
    }
  return heat / static_cast<double>(count);
}

}  // namespace

bool CaseSetting::hides(Effect effect) const {
  return std::ranges::find(plan.hidden, effect) != plan.hidden.end();
}

std::vector<Run> CaseSetting::simulated(const Hidden& hidden, std::size_t runs) const {
  const bool engaged = plan.programme == Programme::forward_only;
  std::vector<Run> driven;
  for (std::size_t index = 0; index < runs; ++index)
    driven.push_back(simulate(robot, hidden, scripts[index], engaged));
  return driven;
}

CaseSetting drawn_setting(const PlannedCase& plan, Random& random) {
  CaseSetting setting{plan, random_robot(random), drawn_details(random), {}};
  if (!plan.programme) {
    const EffectEntry& entry = entry_of(plan.hidden.front());
    setting.plan.programme = one_of(entry.programmes, random);
    setting.plan.channels = one_of(entry.channels, random);
  }
  if (setting.hides(Effect::lever_arm)) setting.details.angle_rad = drawn_marker_rad(plan.expected, random);
  prepare(setting);
  Pose common;
  common.x_m = random.uniform(-0.2, 0.2);
  common.y_m = random.uniform(-0.2, 0.2);
  common.heading_rad = random.uniform(-straight_angle_rad, straight_angle_rad);
  for (std::uint64_t index = 0; index < runs_of_a_case; ++index)
    setting.scripts.push_back(
        drawn_script(setting, index, setting.hides(Effect::surface_patch) ? &common : nullptr));
  setting.details.usual_heat = usual_heat(setting);
  return setting;
}

}  // namespace plants::sixth
