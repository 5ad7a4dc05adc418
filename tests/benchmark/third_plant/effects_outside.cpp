// Structured imperfections that are none of the named effects.
#include "tests/benchmark/plants/text.hpp"
#include "tests/benchmark/third_plant/effects.hpp"

namespace plants::third {

namespace {

std::string shared_supply(Setting& setting) {
  constexpr double lost_at_full_speed = 0.1;
  const RobotSpec& robot = setting.robot;
  const double full_speed_a = 2.0 * robot.motor.drag_n_s_m * robot.fastest_m_s / robot.motor.constant_n_a;
  setting.robot.derating.shared_droop_1_a = lost_at_full_speed / full_speed_a;
  return "both motors hang on one weak regulator: each wheel slows as both draw current (" +
         per_cent(lost_at_full_speed) + " at full speed)";
}

std::string gusts(Setting& setting) {
  setting.robot.odd_force.gust_n = setting.force_n(0.03);
  return "gusts of wind push and turn the robot for 1 to 3 s at random";
}

std::string fixed_hum(Setting& setting) {
  OddForceSpec& odd = setting.robot.odd_force;
  odd.hum_n = setting.force_n(setting.random.uniform(0.03, 0.035));
  odd.hum_hz = setting.random.uniform(0.5, 0.9);
  return "an arm on the robot swings at " + fixed(odd.hum_hz, 2) + " Hz and pushes both wheels";
}

std::string sloshing(Setting& setting) {
  OddForceSpec& odd = setting.robot.odd_force;
  odd.load_share = 0.9;
  odd.load_hz = setting.random.uniform(1.2, 1.8);
  return "a hanging load swings at " + fixed(odd.load_hz, 1) + " Hz between stops of 12 mm";
}

std::string temperature_step(Setting& setting) {
  const double taken = setting.random.uniform(0.13, 0.16);
  setting.robot.derating.protection = taken;
  return "thermal protection takes " + per_cent(taken) + " of the drive at a random moment of each run";
}

std::string random_slip(Setting& setting) {
  setting.robot.slips = {8, 0.3, 0.8};
  return "now and then a wheel loses 65 % of its grip for 0.3 to 0.8 s, anywhere, at any speed";
}

std::string loose_contact(Setting& setting) {
  setting.robot.loose_contacts = {14, 0.12, 0.35};
  return "a loose plug cuts one motor's current for 0.1 to 0.35 s at random";
}

std::string fluid_memory(Setting& setting) {
  setting.robot.derating.fluid_memory = 0.4;
  return "fluid coupling: gain falls with the mean speed of the last 8 s (by 40 % of the share of full "
         "speed)";
}

}  // namespace

std::vector<Effect> outside_effects() {
  const auto outside = [](const char* name, std::string (*apply)(Setting&), Sensing sensing, Style style,
                          double min_reference_hz = 0.0) {
    const Showing showing{sensing, style, Loop::open};
    return Effect{name, apply, showing, showing, min_reference_hz};
  };
  return {
      outside("shared_supply", shared_supply, Sensing::ticks, Style::random_steps),
      outside("gusts", gusts, Sensing::ticks_and_poses, Style::joystick),
      outside("fixed_hum", fixed_hum, Sensing::ticks, Style::go_and_turn),
      outside("sloshing", sloshing, Sensing::ticks, Style::random_steps),
      outside("temperature_step", temperature_step, Sensing::ticks, Style::joystick),
      outside("random_slip", random_slip, Sensing::ticks_and_poses, Style::go_and_turn, 10.0),
      outside("loose_contact", loose_contact, Sensing::ticks, Style::random_steps),
      outside("fluid_memory", fluid_memory, Sensing::ticks, Style::slow_fast_mixture),
  };
}

}  // namespace plants::third
