#include "model/gap/next_experiment/next_experiment.hpp"

#include <algorithm>
#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double wheel_base_m = 0.258;
constexpr double period_s = 0.018;

std::vector<DriveLog> one_run(test::Program program) {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 15.0;
  spec.program = program;
  return test::make_gap_case(spec).runs;
}

TrialModel model_with(const std::vector<std::pair<std::string, std::vector<double>>>& effects) {
  TrialModel model = first_guess({}, period_s, wheel_base_m, 0.08, 0.036);
  for (const auto& [name, parameters] : effects) model.effects.push_back({find_effect(name), 0, parameters});
  return model;
}

// An analysis that ended undecided between two effects.
GapAnalysis undecided(const std::string& name, const std::vector<double>& parameters,
                      const std::string& rival, const std::vector<double>& rival_parameters) {
  GapAnalysis analysis;
  analysis.verdict = Verdict::ambiguous;
  SelectionStep check;
  check.without.model = model_with({});
  for (const auto& [effect, values] : {std::pair{name, parameters}, std::pair{rival, rival_parameters}}) {
    Candidate candidate;
    candidate.fit.model = model_with({{effect, values}});
    candidate.effect = candidate.fit.model.effects.back();
    check.candidates.push_back(candidate);
  }
  analysis.search.final.model = check.candidates.front().fit.model;
  analysis.search.checks.push_back(check);
  Finding found;
  found.setting = {name, "", parameters};
  found.posterior = 0.6;
  found.rivals = {{rival, 0.4}};
  analysis.found.push_back(found);
  return analysis;
}

}  // namespace

TEST_CASE("Every manoeuvre begins and ends at rest, keeps to its limits, and lasts as long as it says") {
  for (const double speed : {0.1, 0.3}) {
    for (const double radius : {0.5, 2.0}) {
      const ManoeuvreLimits limits{speed, 0.15, radius};
      for (const auto& manoeuvre : safe_manoeuvres(limits, wheel_base_m, period_s)) {
        INFO(manoeuvre.name << " at " << speed << " m/s within " << radius << " m");
        const auto& commands = manoeuvre.commands_m_s;
        REQUIRE(commands.size() > 100);
        CHECK((commands.front().left == 0.0 && commands.back().right == 0.0));
        double largest = 0.0;
        double hardest = 0.0;
        WheelPair before;
        for (const auto& u : commands) {
          largest = std::max({largest, std::abs(u.left), std::abs(u.right)});
          hardest = std::max({hardest, std::abs(u.left - before.left), std::abs(u.right - before.right)});
          before = u;
        }
        CHECK(largest <= speed * (1.0 + 1e-9));
        CHECK(hardest <= 0.15 * (1.0 + 1e-9));
        CHECK(period_s * static_cast<double>(commands.size()) < 65.0);
      }
    }
  }
}

TEST_CASE("Between two rivals the next experiment names both and parts them by more than noise") {
  const auto logs = one_run(test::Program::one_speed);
  const auto next = next_experiment(undecided("dead_zone", {0.02, 0.02}, "coulomb_friction", {0.02, 0.06}),
                                    logs, {0.3, 0.15, 1.0}, serial_for);
  REQUIRE(next);
  auto pair = next->separates;
  std::ranges::sort(pair);
  CHECK(pair[0] == "coulomb_friction");
  CHECK(pair[1] == "dead_zone");
  CHECK(next->nats > 3.0);
  CHECK(next->seconds > 5.0);
}

TEST_CASE("On a smaller floor the next experiment stays on it") {
  const auto logs = one_run(test::Program::one_speed);
  const auto analysis = undecided("dead_zone", {0.02, 0.02}, "coulomb_friction", {0.02, 0.06});
  const auto next = next_experiment(analysis, logs, {0.3, 0.15, 0.5}, serial_for);
  REQUIRE(next);
  ModelSimulation robot = analysis.search.final.model.simulation();
  robot.reset({});
  for (const auto& sample : next->commands.samples) {
    robot.step(sample.command_m_s);
    CHECK(std::hypot(robot.pose().x_m, robot.pose().y_m) < 0.5);
  }
}

TEST_CASE("Where nothing is in doubt there is no next experiment") {
  GapAnalysis analysis;
  analysis.verdict = Verdict::nothing_missing;
  CHECK_FALSE(next_experiment(analysis, one_run(test::Program::mixed), {}, serial_for));
  analysis.verdict = Verdict::bad_data;
  analysis.not_testable.push_back({"backlash", "the runs hold no reversal"});
  CHECK_FALSE(next_experiment(analysis, one_run(test::Program::forward_only), {}, serial_for));
}
