// Effects between the command and the motor.
#include "tests/benchmark/fourth_plant/command_blocks.hpp"
#include "tests/benchmark/fourth_plant/delay_line.hpp"
#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fourth {

namespace {

std::string millimetres_per_s(double speed_m_s) {
  return fixed(1000.0 * speed_m_s, 0) + " mm/s";
}

std::string hide_dead_zone(const Setting& setting) {
  const double threshold_m_s = drawn(setting, {0.025, 0.03}, {0.05, 0.065});
  add_to_both(setting.diagram().command, Threshold{threshold_m_s});
  return "firmware sets commands below " + millimetres_per_s(threshold_m_s) + " to zero";
}

// Small: the drive stage of a speed loop; large: the firmware.
std::string hide_saturation(const Setting& setting) {
  const double limit_m_s = setting.top_m_s() * drawn(setting, {0.8, 0.86}, {0.55, 0.65});
  if (setting.large) {
    add_to_both(setting.diagram().command, Limiter{limit_m_s});
    return "firmware limits the command to " + millimetres_per_s(limit_m_s);
  }
  for (DriveSpec& drive : setting.robot().drives) drive.drive_limit_m_s = limit_m_s;
  return "the drive stage in the speed loop ends at " + millimetres_per_s(limit_m_s);
}

std::string hide_rate_limit(const Setting& setting) {
  const double limit_m_s2 = drawn(setting, {2.4, 3.0}, {0.35, 0.5});
  add_to_both(setting.diagram().command, RateLimiter{limit_m_s2});
  return "rate limiter of " + fixed(limit_m_s2, 2) + " m/s2 on the set speed";
}

std::string hide_quantization(const Setting& setting) {
  const double interval_m_s = drawn(setting, {0.022, 0.028}, {0.05, 0.06});
  add_to_both(setting.diagram().command, Quantizer{interval_m_s});
  return "set speed is rounded to " + millimetres_per_s(interval_m_s);
}

std::string hide_delay(const Setting& setting) {
  const double delay_s = drawn(setting, {0.18, 0.24}, {0.4, 0.5});
  add_to_both(setting.diagram().command, DeadTime(delay_s, fine_step_s));
  return "a radio link adds " + fixed(delay_s, 2) + " s of dead time";
}

// Small: a table in the firmware; large: the motor's characteristic, which a proportional loop straightens a
// little.
std::string hide_gain_curve(const Setting& setting) {
  const double bend = drawn(setting, {0.1, 0.13}, {1.3, 1.6});
  if (setting.large) {
    add_to_both(setting.diagram().drive, FlatteningGain{bend, setting.top_m_s()});
    return "the drive flattens out as tanh, bend " + fixed(bend, 2) + ", in a proportional loop";
  }
  add_to_both(setting.diagram().command, BentGain{bend, setting.top_m_s()});
  return "parabolic command curve, bend " + fixed(bend, 2);
}

std::string hide_direction_gain(const Setting& setting) {
  const double gain = 1.0 - drawn(setting, {0.05, 0.07}, {0.15, 0.2});
  add_to_both(setting.diagram().drive, ReverseGain{gain});
  return "brush timing: drive in reverse times " + fixed(gain, 3);
}

std::string hide_asymmetric_response(const Setting& setting) {
  const double up_s = setting.random.uniform(0.03, 0.06);
  const double down_s = up_s + drawn(setting, {0.06, 0.09}, {0.25, 0.35});
  add_to_both(setting.diagram().command, CoastingLag{up_s, down_s});
  return "lag " + fixed(up_s, 2) + " s when speeding up, " + fixed(down_s, 2) + " s when coasting down";
}

}  // namespace

std::vector<Effect> command_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"dead_zone",
       {.programme = multi_sine, .confusable = "stiction"},
       {.programme = random_steps},
       hide_dead_zone},
      {"saturation",
       {.programme = stairs, .loop = Loop::integral},
       {.sensing = poses, .programme = multi_sine},
       hide_saturation},
      {"rate_limit", {.programme = stop_and_go}, {.programme = random_steps}, hide_rate_limit},
      {"command_quantization", {.programme = multi_sine}, {.programme = chirp}, hide_quantization},
      {"transport_delay", {.programme = random_steps}, {.programme = random_steps}, hide_delay},
      {"gain_curve",
       {.programme = random_steps},
       {.programme = multi_sine, .loop = Loop::proportional},
       hide_gain_curve},
      {"direction_gain",
       {.programme = random_steps, .loop = Loop::open},
       {.sensing = poses, .programme = stop_and_go, .loop = Loop::open},
       hide_direction_gain},
      {"asymmetric_response",
       {.programme = random_steps},
       {.programme = stop_and_go},
       hide_asymmetric_response},
  };
}

}  // namespace plants::fourth
