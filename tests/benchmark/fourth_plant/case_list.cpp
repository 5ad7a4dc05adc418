#include "tests/benchmark/fourth_plant/case_list.hpp"

#include <array>
#include <string>
#include <vector>

#include "tests/benchmark/fourth_plant/case_builder.hpp"
#include "tests/benchmark/plants/effect_table.hpp"
#include "tests/benchmark/plants/shuffle.hpp"

namespace plants::fourth {

namespace {

using enum Sensing;
using enum Programme;

struct Mixture {
  std::vector<std::string> names;
  Showing showing;
};

// Chosen so that none of them hides another.
std::vector<Mixture> mixtures() {
  return {
      {{"dead_zone", "gain_drift"}, {.programme = multi_sine, .loop = Loop::open}},
      {{"rate_limit", "direction_gain"}, {.programme = random_steps, .loop = Loop::open}},
      {{"coulomb_friction", "transport_delay"}, {.programme = random_steps, .loop = Loop::proportional}},
      {{"command_quantization", "asymmetric_response"}, {.programme = chirp}},
      {{"stiction", "saturation"}, {.programme = stop_and_go, .loop = Loop::open}},
      {{"voltage_sag", "dead_zone"}, {.programme = random_steps, .loop = Loop::open}},
      {{"encoder_dropout", "rate_limit"}, {.programme = stop_and_go}},
      {{"effective_track", "yaw_bias"}, {.sensing = ticks_and_poses, .programme = spins}},
      {{"lever_arm", "turn_scrub"}, {.sensing = ticks_and_poses, .programme = spins}},
      {{"wheel_scale_mismatch", "acceleration_slip"}, {.sensing = ticks_and_poses, .programme = stop_and_go}},
      {{"wheel_eccentricity", "distance_scale"},
       {.sensing = ticks_and_poses, .programme = laps, .pose_every_s = 0.0}},
      {{"surface_patch", "effective_track"},
       {.sensing = ticks_and_poses, .programme = waypoints, .loop = Loop::open}},
      {{"caster_kick", "backlash", "direction_gain"},
       {.sensing = ticks_and_poses, .programme = stop_and_go, .loop = Loop::open}},
      {{"turn_speed_loss", "saturation", "lever_arm"},
       {.sensing = ticks_and_poses, .programme = random_steps}},
  };
}

struct Untellable {
  std::string name;
  Showing showing;
  double pace = 1.0;
};

// The sensors do not show it, or the drive never wakes it.
std::vector<Untellable> untellable() {
  constexpr double below_the_limit = 0.5;
  return {
      {"effective_track", {.programme = spins}},
      {"wheel_scale_mismatch", {.programme = random_steps}},
      {"floor_slope", {.programme = waypoints}},
      {"backlash", {.programme = waypoints}},
      {"direction_gain", {.sensing = ticks_and_poses, .programme = laps, .loop = Loop::open}},
      {"saturation", {.programme = random_steps}, below_the_limit},
      {"turn_scrub", {.sensing = ticks_and_poses, .programme = straight_stairs}},
      {"caster_kick", {.sensing = poses, .programme = laps}},
  };
}

// Twenty of the pairs of programme and sensors, each programme with at least two sets and each set with five.
void add_clean(std::vector<ExamCase>& cases, CaseBuilder& builder) {
  constexpr std::array programmes{random_steps, multi_sine, waypoints,   laps,
                                  stairs,       chirp,      stop_and_go, spins};
  constexpr std::array sensings{ticks, ticks_and_poses, poses, ticks_and_ends};
  constexpr std::size_t clean_cases = 20;
  for (std::size_t index = 0; index < clean_cases; ++index) {
    const std::size_t round = index / programmes.size();
    cases.push_back(builder.clean({.sensing = sensings[(index + round) % sensings.size()],
                                   .programme = programmes[index % programmes.size()]}));
  }
}

}  // namespace

std::vector<ExamCase> make_cases(std::uint64_t seed) {
  const std::vector<Effect> effects = all_effects();
  std::vector<ExamCase> cases;
  CaseBuilder builder(seed);
  for (const Effect& effect : effects)
    for (const bool large : {false, true}) cases.push_back(builder.single(effect, large));
  for (const Mixture& mixture : mixtures())
    cases.push_back(builder.several(find_effects(effects, mixture.names), mixture.showing));
  add_clean(cases, builder);
  for (const Untellable& item : untellable())
    cases.push_back(builder.cannot_tell(find_effect(effects, item.name), item.showing, item.pace));
  for (const Effect& effect : outside_effects()) cases.push_back(builder.outside(effect));
  shuffle(cases, Random(seed).child(cases.size()));
  for (std::size_t index = 0; index < cases.size(); ++index)
    cases[index].name = case_name(seed, index, cases[index].name, cases[index].size, cases[index].sensing);
  return cases;
}

}  // namespace plants::fourth
