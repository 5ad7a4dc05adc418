#include "model/gap/selection/candidate_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// Wheels that drift by a random walk besides.
GapRun drifting_run(const TrialModel& robot, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step_m(0.0, 2e-5);
  std::uniform_real_distribution<double> size_m_s(-0.25, 0.25);
  WheelPair told_m_s;
  WheelPair drifted_m;
  return test::counted_run(
      robot, 2500,
      [&, random = std::mt19937(seed + 100)](int period) mutable {
        if (period % 30 == 0) told_m_s = {size_m_s(random), size_m_s(random)};
        return told_m_s;
      },
      [&](double, const WheelPair&) {
        drifted_m.left += step_m(random);
        drifted_m.right += step_m(random);
        return drifted_m;
      });
}

// The pair of the first round, of three effects that are tried.
std::optional<Fit> pair_in(const TrialModel& robot) {
  FitProblem train({drifting_run(robot, 1), drifting_run(robot, 2)},
                   {test::counted_metres_per_tick, test::counted_metres_per_tick}, serial_for);
  FitProblem heldout({drifting_run(robot, 3)}, {test::counted_metres_per_tick}, serial_for);
  const SearchLimits limits;
  ModelComparison comparison(train, heldout, limits);
  const std::vector<const EffectInfo*> candidates{find_effect("command_quantization"),
                                                  find_effect("coulomb_friction"), find_effect("dead_zone")};
  CandidateEvaluation evaluation(train, heldout, comparison, candidates, limits, serial_for);
  SelectionStep step = evaluation.evaluate(evaluation.settle(test::counted_robot(), 1));
  step.pair.reset();
  evaluation.pair_the_best(step);
  return step.pair;
}

}  // namespace

TEST_CASE("The best effects of a round are fitted two by two, and those that are there are the pair") {
  TrialModel robot = test::counted_robot();
  robot.effects = {{find_effect("command_quantization"), 0, {0.03, 0.35}},
                   {find_effect("coulomb_friction"), 0, {0.012, 0.03}}};
  const auto pair = pair_in(robot);
  REQUIRE(pair);
  const auto& effects = pair->model.effects;
  REQUIRE(effects.size() == 2);
  for (const TrialEffect& hidden : robot.effects) {
    INFO(hidden.info->name);
    const auto found = std::ranges::find(effects, hidden.info, &TrialEffect::info);
    REQUIRE(found != effects.end());
    CHECK_THAT(found->parameters[0], WithinRel(hidden.parameters[0], 0.1));
  }
}

TEST_CASE("Of a robot without effects no two are fitted together") {
  CHECK(!pair_in(test::counted_robot()));
}
