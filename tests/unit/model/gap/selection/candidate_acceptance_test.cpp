#include "model/gap/selection/candidate_acceptance.hpp"

#include <string>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

TrialEffect effect(const std::string& name, const std::vector<double>& parameters, std::size_t variant = 0) {
  return {find_effect(name), variant, parameters};
}

TrialEffect decoy(std::string_view name, const std::vector<double>& parameters) {
  for (const EffectInfo& info : decoys()) {
    if (info.name == name) return {&info, 0, parameters};
  }
  FAIL("no decoy " << name);
  return {};
}

TrialModel robot_with(const std::vector<TrialEffect>& effects) {
  TrialModel robot = test::counted_robot();
  robot.effects = effects;
  return robot;
}

FitProblem drive_of(const TrialModel& robot) {
  return {
      {test::counted_run(robot, 2000, test::steps_to_and_fro)}, {test::counted_metres_per_tick}, serial_for};
}

struct Said {
  TrialEffect effect;
  double nats = 0.0;  // of training as of held-out runs
};

// Fits of the drive of `robot`; how much each candidate explains is as said. The first one is the best.
std::string next_effect(const TrialModel& robot, const std::vector<Said>& all, double strongest_nats) {
  const FitProblem problem = drive_of(robot);
  const ModelComparison comparison(problem, problem, {});
  const FreeRuns free_runs{[](const TrialModel&) { return false; },
                           [](const TrialModel&, const TrialModel&) { return false; }};
  const CandidateAcceptance acceptance(problem, comparison, {}, free_runs);
  const auto candidate = [&](const Said& said, const Fit& fit) {
    Candidate one;
    one.effect = said.effect;
    one.train_nats = one.heldout_nats = one.score = said.nats;
    one.fit = fit;
    one.heldout_residuals = fit.residuals;
    return one;
  };
  SelectionStep step;
  step.without = problem.fit(robot_with({}), 5);
  for (const Said& said : all)
    step.candidates.push_back(candidate(said, problem.fit(robot_with({said.effect}), 10)));
  SelectionStep before;
  before.candidates = {candidate({effect("backlash", {0.01, 300.0, 1.0}), strongest_nats}, step.without)};
  const std::vector<SelectionStep> so_far{before};
  const Candidate* next = acceptance.next_effect(step, so_far);
  return next == nullptr ? "none" : next->effect.info->name;
}

const TrialEffect gain = effect("direction_gain", {0.06});
const TrialEffect memory = decoy("decoy_memory", {0.3, 1.0});

}  // namespace

TEST_CASE("A name behind a decoy is accepted if it explains something that the decoy does not") {
  const std::vector<Said> candidates{{memory, 900.0}, {gain, 500.0}};
  CHECK(next_effect(robot_with({memory, gain}), candidates, 1000.0) == "direction_gain");
  CHECK(next_effect(robot_with({memory}), candidates, 1000.0) == "none");
}

TEST_CASE("A name that explains little of all is accepted if a decoy explains nothing beside it") {
  const std::vector<Said> candidates{{gain, 100.0}, {memory, 90.0}};
  constexpr double strongest_nats = 1e6;
  CHECK(next_effect(robot_with({gain}), candidates, strongest_nats) == "direction_gain");
  CHECK(next_effect(robot_with({memory, gain}), candidates, strongest_nats) == "none");
  CHECK(next_effect(robot_with({gain}), {{gain, 100.0}}, strongest_nats) == "none");
}

TEST_CASE("Behind the best effect two more are asked, whatever the number of their variants") {
  const auto bias = [](std::size_t variant) {
    return Said{effect("yaw_bias", {0.001}, variant), 15.0};  // too few for a further effect
  };
  const Said zone{effect("dead_zone", {0.001, 0.5}), 14.0};
  const Said mismatch{effect("wheel_scale_mismatch", {0.001}), 13.0};
  const Said clear{gain, 100.0};
  const TrialModel robot = robot_with({gain});
  CHECK(next_effect(robot, {bias(0), bias(1), zone, clear}, 100.0) == "direction_gain");
  CHECK(next_effect(robot, {bias(0), zone, mismatch, clear}, 100.0) == "none");
}
