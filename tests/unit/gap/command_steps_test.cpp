#include "model/gap/command_steps.hpp"

#include "model/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<TrialEffect> steps_in(const test::GapCaseSpec& spec) {
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;
  for (const auto& log : test::make_gap_case(spec).runs) {
    runs.push_back(make_gap_run(log, {}, log.period_s));
    measure_motion(runs.back());
    metres_per_tick.push_back(log.metres_per_tick.value_or(WheelPair{}));
  }
  CoreShape shape;
  shape.shared = !runs.front().has_counts;
  const TrialModel guess = first_guess(shape, runs.front().period_s, runs.front().wheel_base_m, 0.1, 0.036);
  const GapProblem problem(std::move(runs), std::move(metres_per_tick), for_each_in_turn);
  return find_command_steps(problem, problem.fit(guess, 8), *find_effect("command_quantization"),
                            for_each_in_turn);
}

test::GapCaseSpec drives(const std::string& hidden, test::Severity severity = test::Severity::medium) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = severity;
  spec.runs = 3;
  spec.seconds = 60.0;
  return spec;
}

double nearest_step(const std::vector<TrialEffect>& found) {
  for (const auto& effect : found) {
    if (effect.info->variants[effect.variant].name == "nearest") return effect.parameters[0];
  }
  return 0.0;
}

}  // namespace

TEST_CASE("The step in which commands act is found within half a percent, whatever its size") {
  CHECK_THAT(nearest_step(steps_in(drives("command_quantization", test::Severity::small))),
             WithinRel(0.006, 0.005));
  CHECK_THAT(nearest_step(steps_in(drives("command_quantization", test::Severity::medium))),
             WithinRel(0.015, 0.005));
  CHECK_THAT(nearest_step(steps_in(drives("command_quantization", test::Severity::large))),
             WithinRel(0.035, 0.005));
}

TEST_CASE("Poses alone show the step too, where there is one for each row") {
  auto spec = drives("command_quantization", test::Severity::large);
  spec.channels = test::Channels::ref;
  CHECK_THAT(nearest_step(steps_in(spec)), WithinRel(0.035, 0.005));
}

TEST_CASE("Commands that act as they are show no step") {
  CHECK(steps_in(drives("clean")).empty());
}
