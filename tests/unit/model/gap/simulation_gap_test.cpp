// A simulator beside a robot: the runs of both are by a plant that shares no formula with the library.
#include "model/gap/simulation_gap.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> runs_with(const std::string& effects, std::uint64_t seed,
                                test::Severity severity = test::Severity::large, double period_s = 0.03,
                                int count = 2, double seconds = 24.0) {
  test::GapCaseSpec spec;
  spec.name = effects;
  spec.severity = severity;
  spec.seed = seed;
  spec.runs = count;
  spec.seconds = seconds;
  spec.period_s = period_s;
  return test::make_gap_case(spec).runs;
}

SimulationGap gap_between(const std::vector<DriveLog>& simulated, const std::vector<DriveLog>& real) {
  auto gap = analyse_simulation_gap(simulated, real, {}, serial_for, [](const std::string&, double) {});
  if (!gap) FAIL(gap.error().reason);
  return *std::move(gap);
}

// The same as if the log's clock had begun to send commands so much later.
std::vector<DriveLog> commanded_earlier(std::vector<DriveLog> runs, std::size_t periods) {
  for (DriveLog& run : runs) {
    for (std::size_t row = 0; row + periods < run.samples.size(); ++row)
      run.samples[row].command_m_s = run.samples[row + periods].command_m_s;
    run.samples.resize(run.samples.size() - periods);
  }
  return runs;
}

std::vector<DriveLog> by_poses(std::vector<DriveLog> runs) {
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) sample.ticks.reset();
  }
  return runs;
}

const EffectDifference* difference_of(const SimulationGap& gap, const std::string& effect) {
  const auto found = std::ranges::find(gap.differences, effect, &EffectDifference::effect);
  return found == gap.differences.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("A simulation that lacks what the robot has is told so, with its size") {
  const auto gap = gap_between(runs_with("clean", 11), runs_with("dead_zone", 11));
  CHECK(gap.robot.verdict == Verdict::named);
  REQUIRE(gap.robot.found.size() == 1);
  CHECK(gap.robot.found.front().setting.name == "dead_zone");
  const EffectDifference* difference = difference_of(gap, "dead_zone");
  REQUIRE(difference != nullptr);
  CHECK(difference->kind == DifferenceKind::missing);
  CHECK_FALSE(difference->parameters.front().simulation);
  CHECK(difference->parameters.front().robot);
  CHECK_THAT(gap.robot.summary, ContainsSubstring("It lacks dead_zone (threshold "));
}

TEST_CASE("A simulation that has what the robot has not is told so") {
  const auto gap = gap_between(runs_with("dead_zone", 11), runs_with("clean", 11));
  const EffectDifference* difference = difference_of(gap, "dead_zone");
  REQUIRE(difference != nullptr);
  CHECK(difference->kind == DifferenceKind::surplus);
  CHECK(gap.robot.verdict == Verdict::named);
  CHECK(gap.robot.found.empty());
  CHECK_THAT(gap.robot.summary, ContainsSubstring("which the robot has not"));
}

TEST_CASE("Of the same effect in two sizes, both sizes are said") {
  const auto gap =
      gap_between(runs_with("dead_zone", 11, test::Severity::medium), runs_with("dead_zone", 11));
  const EffectDifference* difference = difference_of(gap, "dead_zone");
  REQUIRE(difference != nullptr);
  CHECK(difference->kind == DifferenceKind::wrong_size);
  const auto& threshold = difference->parameters.front();
  REQUIRE(threshold.simulation);
  CHECK(threshold.simulation->value < threshold.robot->value);
  CHECK_THAT(gap.robot.summary, ContainsSubstring("Its dead_zone is wrong: threshold "));
}

TEST_CASE("An effect that shows in no free run of the simulation is the simulation's all the same") {
  constexpr std::uint64_t seed = 4883352381655160406;
  const auto gap = gap_between(runs_with("dead_zone", seed, test::Severity::small, 0.018, 3, 40.0),
                               runs_with("dead_zone", seed, test::Severity::large, 0.018));
  const EffectDifference* difference = difference_of(gap, "dead_zone");
  REQUIRE(difference != nullptr);
  CHECK(difference->kind == DifferenceKind::wrong_size);
}

TEST_CASE("A simulation that does as the robot does has nothing missing, whatever effects both have") {
  const auto gap = gap_between(runs_with("dead_zone", 11), runs_with("dead_zone", 11));
  CHECK(gap.robot.verdict == Verdict::nothing_missing);
  CHECK(gap.robot.found.empty());
  REQUIRE(difference_of(gap, "dead_zone") != nullptr);
  CHECK(difference_of(gap, "dead_zone")->kind == DifferenceKind::same);
}

TEST_CASE("What both have is the same where the simulation shows poses alone, and the robot counts as well") {
  for (const char* effect : {"distance_scale", "wheel_scale_mismatch", "coulomb_friction"}) {
    INFO(effect);
    const auto runs = runs_with(effect, 11, test::Severity::large, 0.03, 6);
    const auto gap = gap_between(by_poses({runs.begin(), runs.begin() + 3}), {runs.begin() + 3, runs.end()});
    INFO(gap.robot.summary);
    CHECK(gap.robot.verdict == Verdict::nothing_missing);
    CHECK(std::ranges::all_of(gap.differences, [](const EffectDifference& difference) {
      return difference.kind == DifferenceKind::same || difference.kind == DifferenceKind::not_shown;
    }));
  }
}

TEST_CASE("A simulator that is off by more than noise has something missing, though no effect differs") {
  const auto runs = runs_with("clean", 11);
  auto gap = gap_between(runs, runs);
  REQUIRE(gap.robot.verdict == Verdict::nothing_missing);
  Score score = gap.robot.train.floor;
  hold_against_simulator(gap, score, gap.robot.test.floor);
  CHECK(gap.robot.verdict == Verdict::nothing_missing);

  score.position_rms_m->value = 0.1;
  Score of_test = gap.robot.test.floor;
  of_test.position_rms_m->value = 0.1;
  hold_against_simulator(gap, score, of_test);
  CHECK(gap.robot.verdict == Verdict::unnamed);
  CHECK_THAT(gap.robot.summary,
             ContainsSubstring("the simulator itself is ") && ContainsSubstring("position"));
}

TEST_CASE("An effect of both is the same where runs stay untouched, too, on which nothing is to be closed") {
  const auto runs = runs_with("dead_zone", 11, test::Severity::large, 0.03, 4);
  const auto gap = gap_between(runs, runs);
  CHECK(gap.robot.untouched);
  CHECK(gap.robot.verdict == Verdict::nothing_missing);
  REQUIRE(difference_of(gap, "dead_zone") != nullptr);
  CHECK(difference_of(gap, "dead_zone")->kind == DifferenceKind::same);
  CHECK(gap.robot.test.before.distance_rms_m.value() < 1.05 * gap.robot.test.after.distance_rms_m.value());
}

TEST_CASE("A robot that answers later than the simulation has a longer delay, by how much") {
  const auto gap = gap_between(runs_with("clean", 11), commanded_earlier(runs_with("clean", 11), 2));
  REQUIRE_FALSE(gap.robot.linear_changes.empty());
  const LinearChange& delay = gap.robot.linear_changes.front();
  CHECK(delay.what == "delay");
  CHECK(std::abs(delay.value - 2 * 0.03) < 0.004);
  CHECK(gap.robot.verdict == Verdict::named);
  CHECK(gap.robot.found.back().setting.name == "transport_delay");
}

TEST_CASE("The lag that stands in an effect of the simulation is no lag that the robot has gained") {
  const auto gap = gap_between(runs_with("asymmetric_response", 12, test::Severity::large, 0.018),
                               runs_with("clean", 12, test::Severity::large, 0.018));
  REQUIRE(difference_of(gap, "asymmetric_response") != nullptr);
  CHECK(difference_of(gap, "asymmetric_response")->kind == DifferenceKind::surplus);
  CHECK(gap.robot.linear_changes.empty());
}

TEST_CASE("A simulation may have a period of its own") {
  const auto gap =
      gap_between(runs_with("clean", 11, test::Severity::large, 0.01), runs_with("dead_zone", 11));
  REQUIRE(difference_of(gap, "dead_zone") != nullptr);
  CHECK(difference_of(gap, "dead_zone")->kind == DifferenceKind::missing);
  CHECK(gap.robot.before.linear_part.period_s == 0.03);
}

TEST_CASE("Runs of a simulation that differ under the same commands are said to be random") {
  auto simulated = runs_with("clean", 11);
  simulated.push_back(simulated.front());
  simulated.back().name = "again";
  for (auto& sample : simulated.back().samples) *sample.reference_x_m += 1e-4 * sample.t_s;
  const auto gap = gap_between(simulated, runs_with("clean", 11));
  REQUIRE_FALSE(gap.remarks.empty());
  CHECK_THAT(gap.remarks.front(), ContainsSubstring("The simulation is random: again and"));
}

TEST_CASE("Of an effect of several components the one is said that it has") {
  EffectDifference slope{"floor_slope", DifferenceKind::missing, "", "", {}};
  slope.parameters.push_back({"along_x", "m/s", std::nullopt, Known{1e-5, {-1e-4, 1e-4}}, true});
  slope.parameters.push_back({"along_y", "m/s", std::nullopt, Known{0.008, {0.0079, 0.0081}}, true});
  CHECK_THAT(in_words(std::vector{slope}), ContainsSubstring("It lacks floor_slope (along_y 0.008 m/s"));
}
