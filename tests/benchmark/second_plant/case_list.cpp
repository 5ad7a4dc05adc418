#include "tests/benchmark/second_plant/case_list.hpp"

#include "tests/benchmark/second_plant/cannot_tell.hpp"
#include "tests/benchmark/second_plant/case_builder.hpp"

namespace plants::second {

namespace {

void add_singles(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects) {
  for (const Effect& effect : effects) {
    cases.push_back(builder.single(effect, small_level));
    cases.push_back(builder.single(effect, large_level));
  }
}

void add_several(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects) {
  struct Mixture {
    std::vector<std::string> names;
    Sensing sensing;
  };
  const std::vector<Mixture> mixtures{
      {{"coulomb_friction", "backlash"}, Sensing::ticks},
      {{"floor_slope", "wheel_scale_mismatch"}, Sensing::ticks_and_poses},
      {{"dead_zone", "saturation"}, Sensing::ticks},
      {{"direction_gain", "yaw_bias"}, Sensing::ticks_and_poses},
      {{"gain_drift", "coulomb_friction"}, Sensing::ticks},
      {{"lever_arm", "effective_track"}, Sensing::ticks_and_poses},
      {{"command_quantization", "rate_limit"}, Sensing::ticks},
      {{"transport_delay", "asymmetric_response"}, Sensing::ticks_and_poses},
      {{"voltage_sag", "stiction"}, Sensing::ticks},
      {{"turn_scrub", "lever_arm", "direction_gain"}, Sensing::ticks_and_poses},
      {{"surface_patch", "distance_scale"}, Sensing::ticks_and_poses},
      {{"caster_kick", "backlash"}, Sensing::ticks_and_poses},
      {{"acceleration_slip", "wheel_scale_mismatch"}, Sensing::ticks_and_poses},
      {{"encoder_dropout", "gain_curve", "yaw_bias"}, Sensing::ticks_and_poses},
  };
  for (const Mixture& mixture : mixtures)
    cases.push_back(builder.several(effects, mixture.names, mixture.sensing));
}

void add_clean(std::vector<Case>& cases, CaseBuilder& builder) {
  constexpr int clean_cases = 16;
  const std::vector<Sensing> turns{Sensing::ticks, Sensing::ticks_and_poses, Sensing::poses,
                                   Sensing::ticks_and_ends};
  for (int index = 0; index < clean_cases; ++index)
    cases.push_back(builder.clean(turns[static_cast<std::size_t>(index) % turns.size()]));
}

void give_names(std::vector<Case>& cases, std::uint64_t seed) {
  for (std::size_t index = 0; index < cases.size(); ++index)
    cases[index].name = case_name(seed, index, cases[index].name, cases[index].size, cases[index].sensing);
}

}  // namespace

std::vector<Case> make_cases(std::uint64_t seed) {
  const std::vector<Effect> effects = all_effects();
  std::vector<Case> cases;
  CaseBuilder builder(seed);
  add_singles(cases, builder, effects);
  add_several(cases, builder, effects);
  add_clean(cases, builder);
  add_cannot_tell(cases, builder, effects);
  for (const Effect& effect : outside_effects()) cases.push_back(builder.outside(effect));
  give_names(cases, seed);
  return cases;
}

}  // namespace plants::second
