#include "model/gap/selection/model_comparison.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/runs/run.hpp"
#include "tests/support/catch.hpp"

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
GapProblem driven(const TrialModel& robot, int periods) {
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
  return {{run}, {WheelPair{}}, for_each_in_turn};
}

}  // namespace

TEST_CASE("What all runs say a little stands before what the training alone says loudly") {
  const std::pair<std::string, std::vector<double>> quiet{"direction_gain", {-0.03}};
  const std::pair<std::string, std::vector<double>> loud{"dead_zone", {0.05, 0.02}};
  const GapProblem train = driven(with_effects({quiet, loud}), 3000);
  const GapProblem heldout = driven(with_effects({quiet}), 3000);
  const Contest contest(train, heldout, {});
  const auto contender = [&](const TrialModel& model) {
    Contender result;
    const auto residuals = train.residuals(model);
    result.fit = {model, squares_of(residuals), residuals, {}};
    return result;
  };
  Round round;
  round.without = contender(with_effects({})).fit;
  round.contenders = {contender(with_effects({loud})), contender(with_effects({quiet}))};
  contest.judge(round);
  REQUIRE(round.contenders.size() == 2);
  CHECK(round.contenders.front().effect.info->name == "direction_gain");
  const auto both = [](const Contender& one) { return one.train_nats + one.heldout_nats; };
  CHECK(both(round.contenders.back()) > both(round.contenders.front()));
  CHECK(contest.good_enough(round.contenders.front()));
  CHECK_FALSE(contest.good_enough(round.contenders.back()));
}

TEST_CASE("A lag that is the same both ways is no asymmetric response, however much it explains") {
  const auto response = [](std::size_t variant, std::vector<double> parameters) {
    TrialModel model = with_effects({});
    model.effects.push_back({find_effect("asymmetric_response"), variant, std::move(parameters)});
    return model;
  };
  const auto stands = [&](const TrialModel& robot) {
    const GapProblem problem = driven(robot, 3000);
    const auto fit = [&](const TrialModel& model) -> GapFit {
      const auto residuals = problem.residuals(model);
      return {model, squares_of(residuals), residuals, {}};
    };
    Round round;
    round.without = fit(with_effects({}));
    round.contenders.emplace_back();
    round.contenders.back().fit = fit(robot);
    const Contest contest(problem, problem, {});
    contest.judge(round);
    return !round.contenders.empty() && contest.good_enough(round.contenders.front());
  };
  constexpr std::size_t command = 0, command_coasting = 2;
  CHECK(stands(response(command, {0.1, 0.0})));
  CHECK_FALSE(stands(response(command, {0.0031, 0.1})));
  CHECK(stands(response(command_coasting, {2.0, 0.05, 0.0})));
  CHECK_FALSE(stands(response(command_coasting, {0.25, 0.1, 0.95})));  // slows down too gently to roll
}

TEST_CASE("What training leaves no doubt of needs less on held-out runs to be confirmed") {
  const GapProblem problem = driven(with_effects({}), 200);
  const Contest contest(problem, problem, {});
  const auto good_enough = [&](double train_nats, double heldout_nats) {
    Contender contender;
    contender.effect = with_effects({{"direction_gain", {-0.02}}}).effects.front();
    contender.train_nats = train_nats;
    contender.heldout_nats = heldout_nats;
    return contest.good_enough(contender);
  };
  CHECK(good_enough(12.0, 12.0));
  CHECK_FALSE(good_enough(12.0, 7.0));
  CHECK(good_enough(40.0, 7.0));
  CHECK_FALSE(good_enough(40.0, 4.0));
  CHECK_FALSE(good_enough(7.0, 40.0));
}

TEST_CASE("What leaves noise alone is worth adding though it is small beside the strongest") {
  const GapProblem runs = driven(with_effects({}), 300);
  const Contest contest(runs, runs, {});
  const auto explaining = [](double nats, double inflation) {
    Contender contender;
    contender.effect = {find_effect("backlash"), 0, {0.01, 300.0, 1.0}};
    contender.train_nats = contender.heldout_nats = nats * inflation;
    contender.inflation = inflation;
    return contender;
  };
  Round first;
  first.contenders = {explaining(10000.0, 1.0)};
  CHECK(contest.worth_adding(explaining(700.0, 30.0), {first}));
  CHECK_FALSE(contest.worth_adding(explaining(300.0, 30.0), {first}));
  CHECK(contest.worth_adding(explaining(300.0, 1.5), {first}));
  CHECK_FALSE(contest.worth_adding(explaining(100.0, 1.5), {first}));
}

TEST_CASE("What is out of its name's character is no contender for it") {
  const GapProblem problem = driven(with_effects({}), 200);  // commands up to 0.2 m/s
  const Contest contest(problem, problem, {});
  const auto stands = [&](const std::string& name, const std::vector<double>& parameters) {
    const TrialModel model = with_effects({{name, parameters}});
    const auto residuals = problem.residuals(model);
    Round round;
    round.without.model = with_effects({});
    round.without.residuals = problem.residuals(round.without.model);
    round.without.squares = squares_of(round.without.residuals);
    round.contenders.resize(1);
    round.contenders.front().fit = {model, squares_of(residuals), residuals, {}};
    contest.judge(round);
    return !round.contenders.empty();
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
GapProblem straight(const TrialModel& robot) {
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
  return {{make_gap_run(log, {}, period_s)}, {*log.metres_per_tick}, for_each_in_turn};
}

Round judged(const GapProblem& problem, const std::vector<TrialEffect>& effects) {
  const Contest contest(problem, problem, {});
  Round round;
  round.without = problem.fit(with_effects({}), 5);
  for (const TrialEffect& effect : effects) {
    TrialModel model = round.without.model;
    model.effects.push_back(effect);
    Contender contender;
    contender.fit = problem.fit(model, 10);
    round.contenders.push_back(contender);
  }
  contest.judge(round);
  return round;
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
  const Round round =
      judged(straight(with_effects({{"direction_gain", {0.06}}})), {same_here, other, direction_gain});
  REQUIRE(round.contenders.size() == 2);
  CHECK(round.contenders.front().effect.info == direction_gain.info);
  CHECK(round.contenders.back().effect.info == other.info);
}

TEST_CASE("What explains as much beside another as alone is no rival of it") {
  const TrialEffect gain{find_effect("direction_gain"), 0, {0.06}};
  const TrialEffect dead_zone{find_effect("dead_zone"), 0, {0.02, 0.5}};
  const TrialEffect same_here{decoy_named("decoy_cross_talk"), 0, {-0.03}};
  const GapProblem problem = straight(with_effects({{"direction_gain", {0.06}}, {"dead_zone", {0.02, 0.5}}}));
  const Contest contest(problem, problem, {});
  const auto stands_beside = [&](const TrialEffect& one, const TrialEffect& other) {
    const Round apart = judged(problem, {one, other});
    const bool first = apart.contenders.front().effect.info == one.info;
    const Contender& mine = first ? apart.contenders.front() : apart.contenders.back();
    const Contender& rival = first ? apart.contenders.back() : apart.contenders.front();
    TrialModel both = rival.fit.model;
    both.effects.push_back(mine.effect);
    return contest.explains_something_else(problem.fit(both, 10), mine, rival);
  };
  CHECK(stands_beside(gain, dead_zone));
  CHECK_FALSE(stands_beside(same_here, gain));
}
