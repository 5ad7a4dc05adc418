#include "model/gap/selection/rival_checks.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/runs/run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;

TrialModel with_effects(const std::vector<TrialEffect>& effects) {
  TrialModel model = test::counted_robot();
  model.effects = effects;
  return model;
}

TrialEffect named(const std::string& name, const std::vector<double>& parameters) {
  return {find_effect(name), 0, parameters};
}

FitProblem some_drive() {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  for (int k = 0; k < 100; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = {0.002 * k, 0.001 * k};
    sample.reference_x_m = 1e-3 * k;
    sample.reference_y_m = 0.0;
    sample.reference_theta_rad = 0.0;
    log.samples.push_back(sample);
  }
  GapRun run = make_gap_run(log, {}, period_s);
  measure_motion(run);
  return {{run}, {WheelPair{}}, serial_for};
}

// With the counts that `robot` would give.
FitProblem counted_drive(const TrialModel& robot) {
  return {
      {test::counted_run(robot, 2000, test::steps_to_and_fro)}, {test::counted_metres_per_tick}, serial_for};
}

struct Said {
  TrialEffect effect;
  double heldout_nats = 0.0;
  double train_nats = 500.0;
};

// Who would take a place, the first one best, as a look leaves it.
SelectionStep check(const std::vector<Said>& all) {
  SelectionStep selection_step;
  for (const Said& said : all) {
    Candidate candidate;
    candidate.effect = said.effect;
    candidate.heldout_nats = said.heldout_nats;
    candidate.train_nats = said.train_nats;
    candidate.score = said.heldout_nats;
    selection_step.candidates.push_back(candidate);
  }
  return selection_step;
}

// What is left of two effects, with what was said for each in its place.
TrialModel left_model(const Said& one, const SelectionStep& check_of_one, const Said& other,
                      const SelectionStep& check_of_other, bool free_runs_closer) {
  FitProblem problem = some_drive();
  ModelComparison comparison(problem, problem, {});
  CandidateEvaluation evaluation(problem, problem, comparison, {}, {}, serial_for);
  const FreeRuns free_runs{[](const TrialModel&) { return true; },
                           [&](const TrialModel&, const TrialModel&) { return free_runs_closer; }};
  RivalChecks checks(problem, comparison, evaluation, {}, free_runs);
  GapSearch result;
  result.final.model = with_effects({one.effect, other.effect});
  result.checks = {check_of_one, check_of_other};
  const bool dropped = checks.drop_idle(result);
  CHECK(dropped == (result.final.model.effects.size() < 2));
  return result.final.model;
}

std::vector<std::string> left_of(const Said& one, const SelectionStep& check_of_one, const Said& other,
                                 const SelectionStep& check_of_other, bool free_runs_closer) {
  const TrialModel left = left_model(one, check_of_one, other, check_of_other, free_runs_closer);
  std::vector<std::string> names;
  for (const auto& effect : left.effects) names.push_back(effect.info->name);
  return names;
}

const Said strong{named("dead_zone", {0.02, 0.5}), 800.0};
const std::vector<std::string> strong_alone{"dead_zone"};

std::vector<std::string> left_beside_strong(const Said& other, const SelectionStep& check_of_other,
                                            bool free_runs_closer) {
  return left_of(strong, check({strong}), other, check_of_other, free_runs_closer);
}

TrialEffect some_decoy() {
  return {&decoys().front(), 0, {0.1, 0.1}};
}

}  // namespace

TEST_CASE("Beside others an effect that explains little stays only where free runs come closer by it") {
  const Said little{named("direction_gain", {-0.02}), 20.0};
  CHECK(left_beside_strong(little, check({little}), false) == strong_alone);
  CHECK(left_beside_strong(little, check({little}), true).size() == 2);
  const Said enough{little.effect, 60.0};
  CHECK(left_beside_strong(enough, check({enough}), false).size() == 2);
  const Said against_training{little.effect, 60.0, -10.0};
  CHECK(left_beside_strong(against_training, check({against_training}), false) == strong_alone);
}

TEST_CASE("Beside others a delay that a core could hold is no effect, a longer one is") {
  const Said linear_part_like{named("transport_delay", {0.04}), 300.0};
  REQUIRE(linear_part_like.effect.info->linear);
  CHECK(left_beside_strong(linear_part_like, check({linear_part_like}), false) == strong_alone);
  CHECK(left_beside_strong(linear_part_like, check({linear_part_like}), true) == strong_alone);
  const Said longer{named("transport_delay", {0.4}), 300.0};
  CHECK(left_beside_strong(longer, check({longer}), false).size() == 2);
}

TEST_CASE("A delay that is clear is left to a core that reaches as far back") {
  const Said clear{named("transport_delay", {0.04}), 300.0};
  const Said doubtful{clear.effect, 60.0};
  const auto weights = [](const Said& delay) {
    return left_model(strong, check({strong}), delay, check({delay}), false).shape.weights;
  };
  CHECK(weights(doubtful) == LinearPartShape{}.weights);
  CHECK(weights(clear) > LinearPartShape{}.weights);
}

TEST_CASE("What a decoy beats beside others goes, whatever free runs say") {
  const Said beaten{named("direction_gain", {-0.02}), 60.0};
  CHECK(left_beside_strong(beaten, check({{some_decoy(), 61.0}, beaten}), true) == strong_alone);
}

TEST_CASE("Beside others what is small and hardly told from its rival goes") {
  const Said rival{named("gain_curve", {0.1, 0.1}), 43.0};
  const Said small{named("direction_gain", {-0.02}), 44.0};
  CHECK(left_beside_strong(small, check({small, rival}), true) == strong_alone);
  const Said clearer{small.effect, 46.0};
  CHECK(left_beside_strong(clearer, check({clearer, rival}), true).size() == 2);
  const Said larger{small.effect, 49.0};
  CHECK(left_beside_strong(larger, check({larger, {rival.effect, 48.0}}), true).size() == 2);
}

TEST_CASE("Of two that are not needed the lesser one goes first") {
  const Said one{named("direction_gain", {-0.02}), 30.0};
  const Said other{named("gain_curve", {0.1, 0.1}), 20.0};
  CHECK(left_of(one, check({one}), other, check({other}), false) ==
        std::vector<std::string>{"direction_gain"});
  CHECK(left_of(other, check({other}), one, check({one}), false) ==
        std::vector<std::string>{"direction_gain"});
}

TEST_CASE("An effect and its rivals are judged where it stands: friction in front of the play") {
  const TrialEffect friction = named("coulomb_friction", {0.03, 0.02});
  const TrialModel robot = with_effects({friction, named("backlash", {0.01, 100.0, 1.0})});
  FitProblem train = counted_drive(robot);
  FitProblem heldout = counted_drive(robot);
  ModelComparison comparison(train, heldout, {});
  const std::vector<const EffectInfo*> candidate_effects{find_effect("coulomb_friction"),
                                                         find_effect("dead_zone"), find_effect("backlash")};
  CandidateEvaluation evaluation(train, heldout, comparison, candidate_effects, {}, serial_for);
  const auto never = [](const auto&...) { return false; };
  const FreeRuns free_runs{never, never};
  RivalChecks checks(train, comparison, evaluation, {}, free_runs);
  GapSearch result;
  result.final = train.fit(robot, steps_of_a_refit);
  checks.check(result);
  REQUIRE(result.checks.size() == 2);
  const Candidate& first = result.checks.front().candidates.front();
  CHECK(first.effect.info == friction.info);
  CHECK(first.behind == 1);
  CHECK_THAT(first.effect.parameters.front(), WithinAbs(0.03, 0.003));
  CHECK(result.final.model.effects.front().info == friction.info);
}

TEST_CASE("What explains something else and more is no doubt of what is there") {
  const TrialEffect present = named("gain_drift", {0.1, 15.0});
  const TrialModel robot = with_effects({named("dead_zone", {0.04, 0.5}), present});
  FitProblem train = counted_drive(robot);
  FitProblem heldout = counted_drive(robot);
  ModelComparison comparison(train, heldout, {});
  const std::vector<const EffectInfo*> candidate_effects{find_effect("dead_zone"), present.info};
  CandidateEvaluation evaluation(train, heldout, comparison, candidate_effects, {}, serial_for);
  const auto never = [](const auto&...) { return false; };
  const FreeRuns free_runs{never, never};
  RivalChecks checks(train, comparison, evaluation, {}, free_runs);
  GapSearch result;
  result.final = train.fit(with_effects({present}), steps_of_a_refit);
  checks.check(result);
  REQUIRE(result.checks.size() == 1);
  const auto& candidates = result.checks.front().candidates;
  REQUIRE(!candidates.empty());
  CHECK(candidates.front().effect.info == present.info);
}
