#include "tests/benchmark/second_plant/cannot_tell.hpp"

#include <cmath>
#include <numbers>

#include "tests/benchmark/plants/effect_table.hpp"
#include "tests/benchmark/second_plant/run.hpp"

namespace plants::second {

namespace {

// The teeth must never part: the same robot without play has to give the same logs.
void compare_without_play(Case& item) {
  item.innocent = item.robot;
  item.innocent.gear.lash_m = 0.0;
}

// With one speed, the bend has the effect of another feed-forward gain.
void compare_with_other_gain(Case& item) {
  item.robot.controller.proportional_v_s_m = 0.0;
  item.innocent = item.robot;
  MotorSpec& motor = item.innocent.motor;
  ControllerSpec& controller = item.innocent.controller;
  const double duty = controller.feedforward_v_s_m * one_speed_m_s(item.robot.fastest_m_s) / motor.supply_v;
  controller.feedforward_v_s_m *= (1.0 + motor.pwm_bend) / (1.0 + motor.pwm_bend * duty);
  motor.pwm_bend = 0.0;
}

// Straight uphill, which a gearbox friction of half the pull per wheel has to imitate.
void compare_with_friction(Case& item) {
  item.keep_heading = true;
  item.robot.floor.downhill_rad = kKeptHeading_rad + std::numbers::pi;
  const double pull_n = item.robot.body.mass_kg * kGravity_m_s2 * std::sin(item.robot.floor.tilt_rad);
  item.innocent.friction.coulomb_n = 0.5 * pull_n;
  item.innocent.friction.breakaway_n = 0.5 * pull_n;
}

// Same charge at every start and a fall with time only: nothing but the volts would tell it from warming up.
void let_voltage_fall_with_time(Case& item) {
  BatterySpec& battery = item.robot.battery;
  battery.drop_per_run_v = 0.0;
  battery.drop_per_s_v = 0.02;
  battery.internal_ohm = 0.0;
  battery.auxiliary_a = 0.0;
}

}  // namespace

void add_cannot_tell(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects) {
  const auto add = [&](const char* name, Sensing sensing, Style style, const char* why) -> Case& {
    cases.push_back(builder.cannot_tell(find_effect(effects, name), sensing, style, why));
    return cases.back();
  };
  compare_without_play(add("backlash", Sensing::ticks, Style::gentle_forward,
                           "slow forward driving keeps the teeth in contact: not one reversal"));
  add("effective_track", Sensing::ticks_and_poses, Style::straight_only,
      "both wheels always alike: never a turn");
  add("lever_arm", Sensing::ticks, Style::rich, "no reference pose, so no reference point");
  compare_with_other_gain(
      add("gain_curve", Sensing::ticks, Style::one_speed,
          "PWM bend under open-loop feed-forward, commands are 0 or one speed: a mere gain"));
  add("dead_zone", Sensing::ticks, Style::no_small_commands, "no command between 0 and the threshold")
      .robot.firmware.minimum_command_m_s = 0.06;
  add("wheel_scale_mismatch", Sensing::ticks, Style::rich,
      "ticks count turns of the wheel, not metres of floor");
  compare_with_friction(
      add("floor_slope", Sensing::ticks, Style::one_heading,
          "always forward and uphill at one heading: a constant loss, as coulomb_friction"));
  let_voltage_fall_with_time(add("voltage_sag", Sensing::ticks, Style::rich,
                                 "volts not logged and falling evenly with time: as gain_drift"));
}

}  // namespace plants::second
