#include "model/gap/candidates/quantization_levels.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::optional<TrialEffect> steps_beside_linear_model(FitProblem& problem, const TrialModel& guess) {
  const Fit fit = problem.fit(guess, 8);
  problem.set_noise(problem.noise_left_by(fit.model));
  return find_command_steps(problem, problem.fit(fit.model, 8), *find_effect("command_quantization"),
                            serial_for);
}

std::optional<TrialEffect> steps_in(const test::GapCaseSpec& spec) {
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;
  for (const auto& log : test::make_gap_case(spec).runs) {
    runs.push_back(make_gap_run(log, {}, log.period_s));
    measure_motion(runs.back());
    metres_per_tick.push_back(log.metres_per_tick.value_or(WheelPair{}));
  }
  LinearPartShape shape;
  shape.shared = !runs.front().has_counts;
  const TrialModel guess = first_guess(shape, runs.front().period_s, runs.front().wheel_base_m, 0.1, 0.036);
  FitProblem problem(std::move(runs), std::move(metres_per_tick), serial_for);
  return steps_beside_linear_model(problem, guess);
}

test::GapCaseSpec drives(const std::string& hidden, test::Severity severity = test::Severity::medium) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = severity;
  spec.runs = 3;
  spec.seconds = 60.0;
  return spec;
}

// Of two sines, so that hardly a command is given twice; with a robot that has these effects, of which some
// are known.
std::optional<TrialEffect> steps_in_sines(const std::vector<TrialEffect>& effects,
                                          const std::vector<TrialEffect>& known = {}) {
  TrialModel robot = test::counted_robot();
  robot.effects = effects;
  const auto command_m_s = [](int period) {
    const double t_s = test::counted_period_s * period;
    return WheelPair{0.15 * std::sin(0.9 * t_s) + 0.1 * std::sin(2.3 * t_s),
                     0.15 * std::sin(0.7 * t_s) + 0.1 * std::cos(1.9 * t_s)};
  };
  FitProblem problem({test::counted_run(robot, 3000, command_m_s)}, {test::counted_metres_per_tick},
                     serial_for);
  TrialModel guess = test::counted_robot();
  guess.effects = known;
  return steps_beside_linear_model(problem, guess);
}

}  // namespace

TEST_CASE("The step in which commands act is found within a percent, whatever its size") {
  for (const auto& [severity, step_m_s] :
       {std::pair{test::Severity::small, 0.006}, std::pair{test::Severity::medium, 0.015},
        std::pair{test::Severity::large, 0.035}}) {
    const auto found = steps_in(drives("command_quantization", severity));
    REQUIRE(found);
    CHECK_THAT(found->parameters[0], WithinRel(step_m_s, 0.01));
    CHECK_THAT(found->parameters[1], WithinAbs(0.5, 0.1));
  }
}

TEST_CASE("Poses alone show the step too, where there is one for each row") {
  auto spec = drives("command_quantization", test::Severity::large);
  spec.channels = test::Channels::ref;
  const auto found = steps_in(spec);
  REQUIRE(found);
  CHECK_THAT(found->parameters[0], WithinRel(0.035, 0.015));
}

TEST_CASE("A step is found in commands that change all the time, and where it rises") {
  for (const double level_edges : {0.2, 0.5, 1.0}) {
    const auto found = steps_in_sines({{find_effect("command_quantization"), 0, {0.02, level_edges}}});
    REQUIRE(found);
    CHECK_THAT(found->parameters[0], WithinRel(0.02, 0.01));
    CHECK_THAT(found->parameters[1], WithinAbs(level_edges, 0.1));
  }
}

TEST_CASE("The steps of a fast robot are found where they are a quarter of its speed") {
  TrialModel robot = test::counted_robot();
  robot.effects = {{find_effect("command_quantization"), 0, {0.25, 0.5}}};
  const auto held_m_s = [](int period) {
    const int hold = period / 50;
    return WheelPair{std::sin(1.7 * hold), std::sin(2.9 * hold + 1.0)};
  };
  FitProblem problem({test::counted_run(robot, 3000, held_m_s)}, {test::counted_metres_per_tick}, serial_for);
  const auto found = steps_beside_linear_model(problem, test::counted_robot());
  REQUIRE(found);
  CHECK_THAT(found->parameters[0], WithinRel(0.25, 0.03));
}

TEST_CASE("A step is found behind a delay") {
  const TrialEffect delay{find_effect("transport_delay"), 0, {0.3}};
  const auto found = steps_in_sines({{find_effect("command_quantization"), 0, {0.02, 0.5}}, delay}, {delay});
  REQUIRE(found);
  CHECK_THAT(found->parameters[0], WithinRel(0.02, 0.01));
  CHECK_THAT(found->parameters[1], WithinAbs(0.5, 0.1));
}

TEST_CASE("A step is found below a limit of speed, so that a fit can begin there") {
  for (const double limit_m_s : {0.06, 0.075, 0.09, 0.12, 0.18}) {
    CAPTURE(limit_m_s);
    const TrialEffect limit{find_effect("saturation"), 0, {limit_m_s, 0.0, 0.0}};
    const auto found =
        steps_in_sines({{find_effect("command_quantization"), 0, {0.02, 0.35}}, limit}, {limit});
    REQUIRE(found);
    CHECK_THAT(found->parameters[0], WithinRel(0.02, 0.03));
    CHECK_THAT(found->parameters[1], WithinAbs(0.35, 0.1));
  }
}

TEST_CASE("Commands that change all the time and act as they are show no step") {
  CHECK(!steps_in_sines({}));
}

TEST_CASE("Commands that act as they are show no step") {
  CHECK(!steps_in(drives("clean")));
}
