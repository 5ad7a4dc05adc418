#include "tests/benchmark/fifth_plant/case_list.hpp"

#include <string>

#include "tests/benchmark/plants/effect_table.hpp"
#include "tests/benchmark/plants/shuffle.hpp"

namespace plants::fifth {

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
      {{"coulomb_friction", "transport_delay"}, {.programme = corridor, .drive = Drive::soft}},
      {{"gain_curve", "rate_limit"}, {.programme = corridor, .drive = Drive::soft}},
      {{"command_quantization", "direction_gain"}, {.programme = teleoperation, .drive = Drive::soft}},
      {{"saturation", "encoder_dropout"}, {.programme = patrol}},
      {{"dead_zone", "gain_drift"}, {.programme = teleoperation, .drive = Drive::soft}},
      {{"voltage_sag", "turn_speed_loss"}, {.programme = turning, .drive = Drive::soft}},
      {{"effective_track", "distance_scale"}, {.sensing = ticks_and_poses, .programme = patrol}},
      {{"wheel_scale_mismatch", "lever_arm"}, {.sensing = ticks_and_poses, .programme = teleoperation}},
      {{"floor_slope", "effective_track"},
       {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft}},
      {{"surface_patch", "wheel_scale_mismatch"},
       {.sensing = ticks_and_poses, .programme = patrol, .drive = Drive::soft}},
      {{"acceleration_slip", "command_quantization"}, {.sensing = ticks_and_poses, .programme = errands}},
      {{"turn_scrub", "yaw_bias"}, {.sensing = ticks_and_poses, .programme = turning, .drive = Drive::soft}},
      {{"caster_kick", "saturation", "distance_scale"},
       {.sensing = ticks_and_poses, .programme = corridor, .drive = Drive::soft}},
      {{"asymmetric_response", "lever_arm", "encoder_dropout"},
       {.sensing = ticks_and_poses, .programme = errands, .drive = Drive::soft}},
  };
}

struct Untellable {
  std::string name;
  Showing showing;
  double pace = 1.0;
};

// The sensors do not show it, or the drive never wakes it.
std::vector<Untellable> untellable() {
  constexpr double below_the_limit = 0.45;
  return {
      {"effective_track", {.programme = turning}},
      {"wheel_scale_mismatch", {.programme = teleoperation}},
      {"lever_arm", {.sensing = ticks_and_poses, .programme = straight_on}},
      {"distance_scale", {.programme = docking}},
      {"direction_gain", {.sensing = ticks_and_poses, .programme = laps, .drive = Drive::soft}},
      {"saturation", {.programme = teleoperation}, below_the_limit},
      {"turn_scrub", {.sensing = ticks_and_poses, .programme = corridor, .drive = Drive::soft}},
      {"caster_kick", {.programme = straight_on, .drive = Drive::soft}},
  };
}

// All programmes and all sets of sensors, dense and once a second.
std::vector<Showing> clean_drives() {
  constexpr double each_second_s = 1.0;
  return {
      {.sensing = ticks, .programme = teleoperation},
      {.sensing = ticks, .programme = docking},
      {.sensing = ticks, .programme = slow, .drive = Drive::soft},
      {.sensing = ticks, .programme = errands, .drive = Drive::stiff},
      {.sensing = ticks, .programme = corridor, .drive = Drive::soft},
      {.sensing = ticks_and_poses, .programme = teleoperation},
      {.sensing = ticks_and_poses, .programme = laps, .pose_every_s = 0.0},
      {.sensing = ticks_and_poses, .programme = errands, .drive = Drive::soft},
      {.sensing = ticks_and_poses, .programme = patrol, .pose_every_s = each_second_s},
      {.sensing = ticks_and_poses, .programme = turning},
      {.sensing = ticks_and_ends, .programme = docking},
      {.sensing = ticks_and_ends, .programme = laps},
      {.sensing = poses, .programme = teleoperation, .pose_every_s = 0.0},
      {.sensing = poses, .programme = patrol},
      {.sensing = poses, .programme = corridor, .drive = Drive::soft},
      {.sensing = poses, .programme = laps, .pose_every_s = each_second_s},
  };
}

}  // namespace

std::vector<BuiltCase> build_cases(std::uint64_t seed) {
  const std::vector<Effect> effects = all_effects();
  std::vector<BuiltCase> cases;
  CaseBuilder builder(seed);
  for (const Effect& effect : effects)
    for (const bool large : {false, true}) cases.push_back(builder.single(effect, large));
  for (const Mixture& mixture : mixtures())
    cases.push_back(builder.several(find_effects(effects, mixture.names), mixture.showing));
  for (const Showing& showing : clean_drives()) cases.push_back(builder.clean(showing));
  for (const Untellable& item : untellable())
    cases.push_back(builder.cannot_tell(find_effect(effects, item.name), item.showing, item.pace));
  for (const Effect& effect : outside_effects())
    for (const bool large : {false, true}) cases.push_back(builder.outside(effect, large));
  shuffle(cases, Random(seed).child(cases.size()));
  for (std::size_t index = 0; index < cases.size(); ++index) {
    ExamCase& exam = cases[index].exam;
    exam.name = case_name(seed, index, exam.name, exam.size, exam.sensing);
  }
  return cases;
}

std::vector<ExamCase> make_cases(std::uint64_t seed) {
  std::vector<ExamCase> exams;
  for (BuiltCase& built : build_cases(seed)) exams.push_back(std::move(built.exam));
  return exams;
}

}  // namespace plants::fifth
