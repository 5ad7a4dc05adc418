#include "tests/benchmark/third_plant/cannot_tell.hpp"

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::third {

namespace {

void give_no_small_command(Case& item) {
  item.robot.firmware.dead_band_rescales = false;
  item.habits.slow_share = 0.0;
  item.limits.slowest_m_s = 1.15 * item.robot.firmware.dead_band_m_s;
  item.hidden.front().how = "firmware drops wheel commands below " +
                            millimetres(item.robot.firmware.dead_band_m_s) +
                            "/s, and none so small is ever given";
}

void give_fresh_pack(Case& item) {
  SupplySpec& supply = item.robot.supply;
  supply.open_circuit_v = 12.02;
  supply.drop_per_run_v = 0.001;
  supply.drop_in_run_v = 0.008;
  supply.internal_ohm = 0.004;
  supply.auxiliary_a = 0.0;
  item.sensors.battery = false;
  item.hidden.front().how = "unregulated PWM from a fresh, stiff pack (0.1 % of sag), voltage not logged";
}

}  // namespace

void add_cannot_tell(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects) {
  const auto add = [&](const char* name, Sensing sensing, Style style, Loop loop, const char* why) -> Case& {
    cases.push_back(builder.cannot_tell(find_effect(effects, name), sensing, style, loop));
    cases.back().hidden.front().how += why;
    return cases.back();
  };
  add("backlash", Sensing::ticks, Style::joystick, Loop::any, ", and the robot never goes backwards")
      .limits.reverses = false;
  give_no_small_command(add("dead_zone", Sensing::ticks, Style::random_steps, Loop::open, ""));
  add("saturation", Sensing::ticks, Style::random_steps, Loop::open,
      ", and commands stay below half of full speed")
      .limits.fastest_m_s *= 0.5;
  add("turn_scrub", Sensing::ticks_and_poses, Style::random_steps, Loop::any, ", and the robot never turns")
      .limits.turns = false;
  add("effective_track", Sensing::ticks_and_poses, Style::go_and_turn, Loop::any,
      ", and the robot never turns")
      .limits.turns = false;
  add("distance_scale", Sensing::ticks, Style::slow_fast_mixture, Loop::any,
      ", and nothing but the count is logged");
  give_fresh_pack(add("voltage_sag", Sensing::ticks, Style::joystick, Loop::open, ""));
  add("coulomb_friction", Sensing::ticks, Style::one_speed, Loop::open,
      ", and one command is held throughout");
}

}  // namespace plants::third
