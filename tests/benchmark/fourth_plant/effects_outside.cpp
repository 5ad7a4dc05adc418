#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/fourth_plant/odd_blocks.hpp"

namespace plants::fourth {

namespace {

std::string hide_spinning_wheel(const Setting& setting) {
  const double per_s = setting.random.uniform(0.15, 0.25);
  add_to_both(setting.diagram().floor, SpinningWheel{{per_s, 0.4, 1.2}, 0.1});
  return "each wheel loses its grip at random moments for about a second";
}

std::string hide_breathing_gain(const Setting& setting) {
  const double swing = setting.random.uniform(0.12, 0.18);
  add_to_both(setting.diagram().drive, BreathingGain{swing, setting.random.uniform(9.0, 14.0)});
  return "gain swings slowly as a sine that starts anywhere";
}

std::string hide_tiring_gain(const Setting& setting) {
  const double loss = setting.random.uniform(0.35, 0.45);
  add_to_both(setting.diagram().drive, TiringGain{loss, setting.random.uniform(5.0, 8.0), setting.top_m_s()});
  return "gain falls with the mean square of the last seconds' drive";
}

std::string hide_slow_for_small(const Setting& setting) {
  const double longest_s = setting.random.uniform(0.3, 0.4);
  add_to_both(setting.diagram().command, SlowForSmall(longest_s, setting.top_m_s(), fine_step_s));
  return "dead time depends on the size of the command";
}

std::string hide_hurrying_filter(const Setting& setting) {
  const double lag_s = setting.random.uniform(0.2, 0.3);
  add_to_both(setting.diagram().command, HurryingFilter{lag_s, 0.4 * setting.top_m_s()});
  return "joystick filter that hurries after large errors and dawdles after small ones";
}

std::string hide_crosstalk(const Setting& setting) {
  setting.diagram().radio.emplace_back(Crosstalk{setting.random.uniform(0.25, 0.35), setting.top_m_s()});
  return "each wheel takes from or gives to the other by the square of its command";
}

std::string hide_lost_packets(const Setting& setting) {
  setting.diagram().radio.emplace_back(LostPackets{{setting.random.uniform(0.25, 0.35), 0.4, 1.0}});
  return "packets get lost at random moments, the last command is held for up to a second";
}

std::string hide_pushes(const Setting& setting) {
  setting.diagram().body.emplace_back(Push{{0.15, 0.3, 0.6}, setting.random.uniform(0.15, 0.25)});
  return "somebody pushes the robot a few times per run";
}

std::string hide_jumping_diameter(const Setting& setting) {
  const double scale = 1.0 - setting.random.uniform(0.06, 0.09);
  setting.diagram().floor[left_side].emplace_back(JumpingDiameter{scale, 12.0, 28.0});
  return "the left tyre comes off its groove in the middle of each run";
}

std::string hide_winding_cable(const Setting& setting) {
  const double rate_rad_s = setting.random.uniform(0.3, 0.45);
  setting.diagram().body.emplace_back(WindingCable{rate_rad_s, 4.0});
  return "a cable winds up, turns the robot back by the cube of the twist, and comes loose";
}

Effect outside(const std::string& name, const Showing& showing, std::string (*hide)(const Setting& setting)) {
  return {name, showing, showing, hide};
}

}  // namespace

std::vector<Effect> outside_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      outside("spinning_wheel", {.sensing = ticks_and_poses, .programme = random_steps}, hide_spinning_wheel),
      outside("breathing_gain", {.programme = multi_sine, .loop = Loop::open}, hide_breathing_gain),
      outside("tiring_gain", {.programme = random_steps, .loop = Loop::open}, hide_tiring_gain),
      outside("slow_for_small", {.programme = random_steps}, hide_slow_for_small),
      outside("hurrying_filter", {.programme = stop_and_go}, hide_hurrying_filter),
      outside("crosstalk", {.programme = multi_sine}, hide_crosstalk),
      outside("lost_packets", {.programme = random_steps}, hide_lost_packets),
      outside("pushes", {.sensing = ticks_and_poses, .programme = waypoints}, hide_pushes),
      outside("jumping_diameter", {.sensing = ticks_and_poses, .programme = spins}, hide_jumping_diameter),
      outside("winding_cable", {.sensing = poses, .programme = random_steps}, hide_winding_cable),
  };
}

}  // namespace plants::fourth
