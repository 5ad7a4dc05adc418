#include "tests/benchmark/third_plant/case_list.hpp"

#include "tests/benchmark/plants/shuffle.hpp"
#include "tests/benchmark/third_plant/cannot_tell.hpp"
#include "tests/benchmark/third_plant/case_builder.hpp"

namespace plants::third {

namespace {

void add_several(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects) {
  using enum Sensing;
  using enum Style;
  struct Mixture {
    std::vector<std::string> names;
    Sensing sensing;
    Style style;
  };
  const std::vector<Mixture> mixtures{
      {{"coulomb_friction", "backlash"}, ticks, random_steps},
      {{"coulomb_friction", "gain_curve"}, ticks, slow_fast_mixture},
      {{"dead_zone", "rate_limit"}, ticks, random_steps},
      {{"effective_track", "wheel_scale_mismatch"}, ticks_and_poses, go_and_turn},
      {{"effective_track", "lever_arm"}, ticks_and_poses, joystick},
      {{"turn_scrub", "distance_scale"}, ticks_and_poses, random_steps},
      {{"voltage_sag", "saturation"}, ticks, random_steps},
      {{"command_quantization", "rate_limit"}, ticks, random_steps},
      {{"yaw_bias", "floor_slope"}, ticks_and_poses, go_and_turn},
      {{"gain_drift", "wheel_scale_mismatch"}, ticks_and_poses, joystick},
      {{"caster_kick", "turn_speed_loss"}, ticks_and_poses, go_and_turn},
      {{"coulomb_friction", "backlash", "effective_track"}, ticks_and_poses, random_steps},
      {{"distance_scale", "lever_arm", "yaw_bias"}, ticks_and_poses, joystick},
      {{"saturation", "direction_gain", "gain_drift"}, ticks, random_steps},
  };
  for (const Mixture& mixture : mixtures)
    cases.push_back(builder.several(effects, mixture.names, mixture.sensing, mixture.style));
}

// Every style with every set of sensors.
void add_clean(std::vector<Case>& cases, CaseBuilder& builder) {
  const std::vector<Sensing> sensings{Sensing::ticks, Sensing::ticks_and_poses, Sensing::poses,
                                      Sensing::ticks_and_ends};
  const std::vector<Style> styles{Style::random_steps, Style::joystick, Style::go_and_turn,
                                  Style::slow_fast_mixture};
  for (const Style style : styles)
    for (const Sensing sensing : sensings) cases.push_back(builder.clean(sensing, style));
}

}  // namespace

std::vector<Case> make_cases(std::uint64_t seed) {
  const std::vector<Effect> effects = all_effects();
  std::vector<Case> cases;
  CaseBuilder builder(seed);
  for (const Effect& effect : effects)
    for (const bool large : {false, true}) cases.push_back(builder.single(effect, large));
  add_several(cases, builder, effects);
  add_clean(cases, builder);
  add_cannot_tell(cases, builder, effects);
  for (const Effect& effect : outside_effects()) cases.push_back(builder.outside(effect));
  shuffle(cases, Random(seed).child(cases.size()));
  return cases;
}

}  // namespace plants::third
