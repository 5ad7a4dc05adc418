#include "model/gap/selection/model_comparison.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/runs/run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double wheel_base_m = 0.25;

TrialModel with_effects(const std::vector<std::pair<std::string, std::vector<double>>>& effects) {
  TrialModel model = first_guess({}, period_s, wheel_base_m, 0.06, 0.04);
  for (const auto& [name, parameters] : effects) model.effects.push_back({find_effect(name), 0, parameters});
  return model;
}

// Slow turns to and fro, with a reference that rounds to a tenth of a millimetre.
FitProblem driven(const TrialModel& robot, int periods) {
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  const auto rounded = [](double value) { return 1e-4 * std::round(1e4 * value); };
  DriveLog log;
  log.wheel_base_m = wheel_base_m;
  log.period_s = period_s;
  for (int k = 0; k < periods; ++k) {
    const double time_s = period_s * k;
    const double forward = 0.15 * std::sin(0.4 * time_s);
    DriveSample sample;
    sample.t_s = time_s;
    sample.command_m_s = {forward, forward + 0.05 * std::sin(0.23 * time_s)};
    sample.reference_x_m = rounded(simulation.pose().x_m);
    sample.reference_y_m = rounded(simulation.pose().y_m);
    sample.reference_theta_rad = rounded(simulation.pose().theta_rad);
    log.samples.push_back(sample);
    simulation.step(sample.command_m_s);
  }
  GapRun run = make_gap_run(log, {}, period_s);
  measure_motion(run);
  return {{run}, {WheelPair{}}, serial_for};
}

}  // namespace

TEST_CASE("What all runs say a little stands before what the training alone says loudly") {
  const std::pair<std::string, std::vector<double>> quiet{"direction_gain", {-0.03}};
  const std::pair<std::string, std::vector<double>> loud{"dead_zone", {0.05, 0.02}};
  const FitProblem train = driven(with_effects({quiet, loud}), 3000);
  const FitProblem heldout = driven(with_effects({quiet}), 3000);
  const ModelComparison comparison(train, heldout, {});
  const auto candidate = [&](const TrialModel& model) {
    Candidate result;
    const auto residuals = train.residuals(model);
    result.fit = {model, sum_squares_of(residuals), residuals};
    return result;
  };
  SelectionStep selection_step;
  selection_step.without = candidate(with_effects({})).fit;
  selection_step.candidates = {candidate(with_effects({loud})), candidate(with_effects({quiet}))};
  comparison.judge(selection_step);
  REQUIRE(selection_step.candidates.size() == 2);
  CHECK(selection_step.candidates.front().effect.info->name == "direction_gain");
  const auto both = [](const Candidate& one) { return one.train_nats + one.heldout_nats; };
  CHECK(both(selection_step.candidates.back()) > both(selection_step.candidates.front()));
  CHECK(comparison.good_enough(selection_step.candidates.front()));
  CHECK_FALSE(comparison.good_enough(selection_step.candidates.back()));
}

TEST_CASE("A lag that is the same both ways is no asymmetric response, however much it explains") {
  const auto response = [](std::size_t variant, std::vector<double> parameters) {
    TrialModel model = with_effects({});
    model.effects.push_back({find_effect("asymmetric_response"), variant, std::move(parameters)});
    return model;
  };
  const auto stands = [&](const TrialModel& robot) {
    const FitProblem problem = driven(robot, 3000);
    const auto fit = [&](const TrialModel& model) -> Fit {
      const auto residuals = problem.residuals(model);
      return {model, sum_squares_of(residuals), residuals};
    };
    SelectionStep selection_step;
    selection_step.without = fit(with_effects({}));
    selection_step.candidates.emplace_back();
    selection_step.candidates.back().fit = fit(robot);
    const ModelComparison comparison(problem, problem, {});
    comparison.judge(selection_step);
    return !selection_step.candidates.empty() && comparison.good_enough(selection_step.candidates.front());
  };
  constexpr std::size_t command = 0, command_coasting = 2;
  CHECK(stands(response(command, {0.1, 0.0})));
  CHECK_FALSE(stands(response(command, {0.0031, 0.1})));
  CHECK(stands(response(command_coasting, {2.0, 0.05, 0.0, 3.0})));
  CHECK_FALSE(stands(response(command_coasting, {0.25, 0.1, 0.95, 3.0})));  // slows down too gently to roll
}

TEST_CASE("What training leaves no doubt of needs less on held-out runs to be confirmed") {
  const FitProblem problem = driven(with_effects({}), 200);
  const ModelComparison comparison(problem, problem, {});
  const auto good_enough = [&](double train_nats, double heldout_nats) {
    Candidate candidate;
    candidate.effect = with_effects({{"direction_gain", {-0.02}}}).effects.front();
    candidate.train_nats = train_nats;
    candidate.heldout_nats = heldout_nats;
    return comparison.good_enough(candidate);
  };
  CHECK(good_enough(12.0, 12.0));
  CHECK_FALSE(good_enough(12.0, 7.0));
  CHECK(good_enough(40.0, 7.0));
  CHECK_FALSE(good_enough(40.0, 4.0));
  CHECK_FALSE(good_enough(7.0, 40.0));
}

TEST_CASE("What held-out runs hardly show is confirmed by training runs left out, if it is in each of them") {
  const TrialModel effect = with_effects({{"direction_gain", {-0.03}}});
  const TrialModel nothing = with_effects({});
  const auto with_little_noise = [](FitProblem problem) {
    NoiseModel noise = problem.noise();
    for (TravelNoise& channel : noise.channel) channel = {1e-4, 1e-3};
    problem.set_noise(noise);
    return problem;
  };
  const auto of_two = [&](const TrialModel& one, const TrialModel& other) {
    return with_little_noise(
        FitProblem({driven(one, 2000).runs().front(), driven(other, 1500).runs().front()},
                   {WheelPair{}, WheelPair{}}, serial_for));
  };
  const auto judged = [&](const FitProblem& train, const FitProblem& heldout) {
    const ModelComparison comparison(train, heldout, {});
    SelectionStep step;
    step.without = train.fit(nothing, 0);
    step.candidates.resize(1);
    step.candidates.front().fit = train.fit(effect, 0);
    comparison.judge(step);
    REQUIRE(step.candidates.size() == 1);
    return std::pair(step.candidates.front(), comparison.good_enough(step.candidates.front()));
  };
  const FitProblem hardly_backward =
      with_little_noise(driven(effect, 440));  // for less than a second, and so hardly shows it
  const auto [in_both, confirmed] = judged(of_two(effect, effect), hardly_backward);
  CHECK(in_both.left_out_nats > 0.0);
  CHECK(confirmed);
  // Where it cannot act, other runs are held out in the place of these.
  const FitProblem forward_alone = with_little_noise(driven(effect, 100));
  const auto [absent, confirmed_by_none] = judged(of_two(effect, effect), forward_alone);
  CHECK(absent.left_out_nats == 0.0);
  CHECK_FALSE(confirmed_by_none);
  const auto [held_out, confirmed_by_it] =
      judged(of_two(effect, effect), with_little_noise(driven(effect, 2000)));
  CHECK(held_out.left_out_nats == 0.0);
  CHECK(confirmed_by_it);
  const auto [contradicted, named_all_the_same] =
      judged(of_two(effect, effect), with_little_noise(driven(nothing, 2000)));
  CHECK(contradicted.left_out_nats == 0.0);
  CHECK_FALSE(named_all_the_same);
}

TEST_CASE("The less of what an effect leaves is correlated, the smaller it may be beside the strongest") {
  const FitProblem runs = driven(with_effects({}), 300);
  const ModelComparison comparison(runs, runs, {});
  const auto explaining = [](double nats, double autocorrelation_factor) {
    Candidate candidate;
    candidate.effect = {find_effect("backlash"), 0, {0.01, 300.0, 1.0}};
    candidate.train_nats = candidate.heldout_nats = nats * autocorrelation_factor;
    candidate.train_autocorrelation_factor = candidate.heldout_autocorrelation_factor =
        autocorrelation_factor;
    return candidate;
  };
  SelectionStep first;
  first.candidates = {explaining(10000.0, 1.0)};
  const std::vector<SelectionStep> so_far{first};
  CHECK(comparison.worth_adding(explaining(700.0, 30.0), so_far));
  CHECK_FALSE(comparison.worth_adding(explaining(300.0, 30.0), so_far));
  CHECK(comparison.worth_adding(explaining(300.0, 3.0), so_far));
  CHECK_FALSE(comparison.worth_adding(explaining(200.0, 3.0), so_far));
  CHECK(comparison.worth_adding(explaining(100.0, 1.5), so_far));
  CHECK(comparison.worth_adding(explaining(40.0, 1.0), so_far));
  CHECK_FALSE(comparison.worth_adding(explaining(25.0, 1.0), so_far));
}

TEST_CASE("Correlated residuals of training runs make no less of what held-out runs say") {
  const FitProblem runs = driven(with_effects({}), 300);
  const ModelComparison comparison(runs, runs, {});
  const auto named = [&](double train_factor, double heldout_factor) {
    Candidate candidate;
    candidate.effect = {find_effect("stiction"), 0, {0.03, 0.01, 0.1, 0.01}};
    candidate.train_nats = 3000.0;
    candidate.heldout_nats = 100.0;
    candidate.train_autocorrelation_factor = train_factor;
    candidate.heldout_autocorrelation_factor = heldout_factor;
    return comparison.good_enough(candidate);
  };
  CHECK(named(20.0, 4.0));
  CHECK_FALSE(named(4.0, 20.0));
}

TEST_CASE("An effect on the motion is not measured by what a strong one of the wheels explains of counts") {
  const auto explaining = [](const char* effect, std::vector<double> parameters, double nats) {
    Candidate candidate;
    candidate.effect = {find_effect(effect), 0, std::move(parameters)};
    candidate.train_nats = candidate.heldout_nats = nats;
    return candidate;
  };
  SelectionStep first;
  first.candidates = {explaining("saturation", {0.2, 0.0, 0.0}, 1e5)};
  const std::vector<SelectionStep> so_far{first};
  const Candidate unequal_wheels = explaining("wheel_scale_mismatch", {0.01}, 50.0);
  const Candidate friction = explaining("coulomb_friction", {0.01}, 50.0);
  const Candidate too_little = explaining("wheel_scale_mismatch", {0.01}, 15.0);
  const auto worth_adding = [&](const FitProblem& runs, const Candidate& candidate) {
    return ModelComparison(runs, runs, {}).worth_adding(candidate, so_far);
  };
  const TrialModel nothing = with_effects({});
  const auto swing_m_s = [](double time_s) {
    return WheelPair{0.2 * std::sin(time_s), 0.2 * std::sin(1.3 * time_s)};
  };
  const FitProblem counted = test::seen_drive(nothing, 300, swing_m_s, test::Counts::of_wheels);
  CHECK(worth_adding(counted, unequal_wheels));
  CHECK_FALSE(worth_adding(counted, too_little));
  CHECK_FALSE(worth_adding(counted, friction));
  CHECK_FALSE(worth_adding(driven(nothing, 300), unequal_wheels));  // by poses alone, both show in the same
}

TEST_CASE("What is out of its name's character is no candidate for it") {
  const FitProblem problem = driven(with_effects({}), 200);  // commands up to 0.2 m/s
  const ModelComparison comparison(problem, problem, {});
  const auto stands = [&](const std::string& name, const std::vector<double>& parameters) {
    const TrialModel model = with_effects({{name, parameters}});
    const auto residuals = problem.residuals(model);
    SelectionStep selection_step;
    selection_step.without.model = with_effects({});
    selection_step.without.residuals = problem.residuals(selection_step.without.model);
    selection_step.without.sum_squares = sum_squares_of(selection_step.without.residuals);
    selection_step.candidates.resize(1);
    selection_step.candidates.front().fit = {model, sum_squares_of(residuals), residuals};
    comparison.judge(selection_step);
    return !selection_step.candidates.empty();
  };
  CHECK(stands("saturation", {0.15, 0.1, 0.0}));
  CHECK_FALSE(stands("saturation", {1.0, 0.4, 0.0}));  // limits acceleration, and no speed
  CHECK(stands("rate_limit", {1.0, 1.0}));
  CHECK_FALSE(stands("rate_limit", {1.0, 5.0}));  // comes to rest at 0.2 m/s: limits speed
  CHECK(stands("stiction", {0.03, 0.005, 0.1, 0.01}));
  CHECK_FALSE(stands("stiction", {0.003, 0.02, 0.1, 0.01}));  // mostly dry friction
}

namespace {

// Both wheels always at the same speed, to and fro: each one's command has the size of the other's.
FitProblem straight(const TrialModel& robot) {
  constexpr double metres_per_tick = 0.0005;
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = wheel_base_m;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  double way_m = 0.0;
  for (int k = 0; k < 1500; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    const double speed_m_s = 0.1 * (1 + k / 60 % 3) * (k / 60 % 2 == 0 ? 1 : -1);
    sample.command_m_s = {speed_m_s, speed_m_s};
    sample.ticks = WheelTicks{std::llround(way_m / metres_per_tick), std::llround(way_m / metres_per_tick)};
    log.samples.push_back(sample);
    way_m += period_s * simulation.step(sample.command_m_s).wheel_m_s.left;
  }
  return {{make_gap_run(log, {}, period_s)}, {*log.metres_per_tick}, serial_for};
}

SelectionStep judged(const FitProblem& problem, const std::vector<TrialEffect>& effects) {
  const ModelComparison comparison(problem, problem, {});
  SelectionStep selection_step;
  selection_step.without = problem.fit(with_effects({}), 5);
  for (const TrialEffect& effect : effects) {
    TrialModel model = selection_step.without.model;
    model.effects.push_back(effect);
    Candidate candidate;
    candidate.fit = problem.fit(model, 10);
    selection_step.candidates.push_back(candidate);
  }
  comparison.judge(selection_step);
  return selection_step;
}

const EffectInfo* decoy_named(std::string_view name) {
  for (const EffectInfo& decoy : decoys()) {
    if (decoy.name == name) return &decoy;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("A decoy that does the same as a name on these runs is no rival of it") {
  const TrialEffect direction_gain{find_effect("direction_gain"), 0, {0.06}};
  const TrialEffect same_here{decoy_named("decoy_cross_talk"), 0, {-0.03}};
  const TrialEffect other{decoy_named("decoy_memory"), 0, {0.05, 1.0}};
  REQUIRE(same_here.info != nullptr);
  REQUIRE(other.info != nullptr);
  const SelectionStep selection_step =
      judged(straight(with_effects({{"direction_gain", {0.06}}})), {same_here, other, direction_gain});
  REQUIRE(selection_step.candidates.size() == 2);
  CHECK(selection_step.candidates.front().effect.info == direction_gain.info);
  CHECK(selection_step.candidates.back().effect.info == other.info);
}

TEST_CASE("What explains as much beside another as alone is no rival of it") {
  const TrialEffect gain{find_effect("direction_gain"), 0, {0.06}};
  const TrialEffect dead_zone{find_effect("dead_zone"), 0, {0.02, 0.5}};
  const TrialEffect same_here{decoy_named("decoy_cross_talk"), 0, {-0.03}};
  const FitProblem problem = straight(with_effects({{"direction_gain", {0.06}}, {"dead_zone", {0.02, 0.5}}}));
  const ModelComparison comparison(problem, problem, {});
  const auto stands_beside = [&](const TrialEffect& one, const TrialEffect& other) {
    const SelectionStep apart = judged(problem, {one, other});
    const bool first = apart.candidates.front().effect.info == one.info;
    const Candidate& mine = first ? apart.candidates.front() : apart.candidates.back();
    const Candidate& rival = first ? apart.candidates.back() : apart.candidates.front();
    TrialModel both = rival.fit.model;
    both.effects.push_back(mine.effect);
    return comparison.explains_something_else(problem.fit(both, 10), mine, rival);
  };
  CHECK(stands_beside(gain, dead_zone));
  CHECK_FALSE(stands_beside(same_here, gain));
}

TEST_CASE("A delay is beyond a linear part together with what the linear part's own weights hold of it") {
  const TrialEffect delay{find_effect("transport_delay"), 0, {0.07}};
  constexpr double period_s = 0.02;
  const auto with_weights_late_by = [](double delay_s) {
    return first_guess({.weights = 6}, period_s, 0.25, 0.06, delay_s);
  };
  CHECK_FALSE(beyond_a_linear_part(with_weights_late_by(0.02), delay));
  CHECK(beyond_a_linear_part(with_weights_late_by(0.08), delay));
}

TEST_CASE("Two periods of delay are a linear part's") {
  const TrialEffect delay{find_effect("transport_delay"), 0, {0.15}};
  CHECK(beyond_a_linear_part(first_guess({.weights = 3}, 0.02, 0.25, 0.06, 0.0), delay));
  CHECK_FALSE(beyond_a_linear_part(first_guess({.weights = 3}, 0.1, 0.25, 0.06, 0.0), delay));
}
