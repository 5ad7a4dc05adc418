#include "tests/benchmark/sixth_plant/case_plan.hpp"

#include <array>

#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

namespace {

using enum Effect;
using enum Programme;
using enum Channels;

// Chosen so that none of them hides another.
std::vector<PlannedCase> mixtures() {
  std::vector<PlannedCase> cases{
      {.name = "", .hidden = {dead_zone, gain_drift}, .programme = creep, .channels = ticks},
      {.name = "",
       .hidden = {coulomb_friction, voltage_sag},
       .programme = teleoperation,
       .channels = ticks_and_poses},
      {.name = "", .hidden = {backlash, direction_gain}, .programme = steps, .channels = ticks},
      {.name = "",
       .hidden = {saturation, rate_limit},
       .programme = steps,
       .channels = ticks_and_poses_each_second},
      {.name = "",
       .hidden = {wheel_scale_mismatch, effective_track},
       .programme = eights,
       .channels = ticks_and_poses},
      {.name = "", .hidden = {lever_arm, yaw_bias}, .programme = squares, .channels = ticks_and_poses},
      {.name = "",
       .hidden = {transport_delay, direction_gain},
       .programme = teleoperation,
       .channels = ticks},
      {.name = "", .hidden = {stiction, gain_drift}, .programme = goals, .channels = ticks_and_poses},
      {.name = "", .hidden = {turn_scrub, distance_scale}, .programme = eights, .channels = ticks_and_poses},
      {.name = "", .hidden = {caster_kick, lever_arm}, .programme = steps, .channels = ticks_and_poses},
      {.name = "", .hidden = {floor_slope, saturation}, .programme = squares, .channels = ticks_and_poses},
      {.name = "",
       .hidden = {surface_patch, dead_zone},
       .programme = teleoperation,
       .channels = ticks_and_poses},
      {.name = "",
       .hidden = {dead_zone, rate_limit, wheel_scale_mismatch},
       .programme = teleoperation,
       .channels = ticks_and_poses},
      {.name = "",
       .hidden = {gain_curve, gain_drift, effective_track},
       .programme = teleoperation,
       .channels = ticks_and_poses},
  };
  for (std::size_t index = 0; index < cases.size(); ++index) {
    PlannedCase& mixture = cases[index];
    for (const Effect effect : mixture.hidden)
      mixture.name += (mixture.name.empty() ? "" : "+") + entry_of(effect).name;
    mixture.size = index % 3 == 2 ? Size::large : Size::medium;
  }
  return cases;
}

// The sensors do not show it, or the drive never wakes it.
std::vector<PlannedCase> untellable() {
  constexpr Size size = Size::large;
  constexpr Expected expected = Expected::not_named;
  return {
      {"backlash_without_reversal", {backlash}, size, expected, forward_only, ticks},
      {"turn_scrub_on_straight", {turn_scrub}, size, expected, straight, ticks_and_poses},
      {"effective_track_on_straight", {effective_track}, size, expected, straight, ticks_and_poses},
      {"saturation_on_slow", {saturation}, size, expected, slow_only, ticks},
      {"caster_kick_without_reversal", {caster_kick}, size, expected, forward_only, ticks_and_poses},
      {"lever_arm_on_straight", {lever_arm}, size, expected, straight, ticks_and_poses},
  };
}

// All ordinary programmes, and all that a log can have.
std::vector<PlannedCase> clean_cases(std::uint64_t seed) {
  constexpr std::array programmes{teleoperation, squares, eights, steps, creep, goals};
  constexpr std::array channels{ticks, ticks_and_poses, ticks_and_poses_each_second, poses};
  constexpr std::size_t count = 16;
  std::vector<PlannedCase> cases;
  for (std::size_t index = 0; index < count; ++index)
    cases.push_back({.name = "clean",
                     .hidden = {},
                     .expected = Expected::nothing_missing,
                     .programme = programmes[(index * 5 + seed) % programmes.size()],
                     .channels = channels[(index + index / 4) % channels.size()]});
  return cases;
}

void append(std::vector<PlannedCase>& cases, const std::vector<PlannedCase>& more) {
  cases.insert(cases.end(), more.begin(), more.end());
}

void append_in_two_sizes(std::vector<PlannedCase>& cases, const std::vector<EffectEntry>& entries,
                         const std::string& prefix, Expected expected) {
  for (const EffectEntry& entry : entries)
    for (const Size size : {Size::small, Size::large})
      cases.push_back({prefix + entry.name, {entry.effect}, size, expected});
}

}  // namespace

std::string name_of(Size size) {
  switch (size) {
    case Size::none:
      return "none";
    case Size::small:
      return "small";
    case Size::medium:
      return "medium";
    case Size::large:
      break;
  }
  return "large";
}

std::string name_of(Expected expected) {
  switch (expected) {
    case Expected::named:
      return "named";
    case Expected::nothing_missing:
      return "nothing_missing";
    case Expected::unnamed:
      return "unnamed";
    case Expected::not_named:
      break;
  }
  return "not_named";
}

std::vector<PlannedCase> planned_cases(std::uint64_t seed) {
  constexpr std::uint64_t first_stream = 1000;
  std::vector<PlannedCase> cases;
  append_in_two_sizes(cases, named_effects(), "", Expected::named);
  append(cases, mixtures());
  append(cases, clean_cases(seed));
  append_in_two_sizes(cases, outside_effects(), "outside_", Expected::unnamed);
  append(cases, untellable());
  for (std::size_t index = 0; index < cases.size(); ++index)
    cases[index].seed = mixed_seed(seed, first_stream + index);
  return cases;
}

}  // namespace plants::sixth
