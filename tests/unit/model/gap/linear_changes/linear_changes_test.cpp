// A given model whose linear part is wrong.
#include <algorithm>
#include <cmath>

#include "model/gap/analysis.hpp"
#include "model/gap/linear_changes/command_correction.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// Runs of a robot of which nothing is missing, and the linear model of it.
struct Robot {
  std::vector<DriveLog> runs;
  RobotModel model;
};

GapAnalysis analysed(const std::vector<DriveLog>& runs, const GapOptions& options) {
  const std::span<const DriveLog> all(runs);
  auto analysis =
      analyse_gap(all.first(2), all.subspan(2), options, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

const Robot& robot() {
  static const Robot made = [] {
    test::GapCaseSpec spec;
    spec.name = "clean";
    spec.seed = 52;
    spec.runs = 3;
    spec.seconds = 25.0;
    spec.period_s = 0.03;
    auto runs = test::make_gap_case(spec).runs;
    return Robot{runs, analysed(runs, {.limits = {.max_effects = 0}}).after};
  }();
  return made;
}

// The robot obeys each command so many rows later than the log of before says.
std::vector<DriveLog> later(std::vector<DriveLog> runs, std::size_t rows) {
  for (DriveLog& run : runs) {
    const auto sent = run.samples;
    for (std::size_t i = 0; i < run.samples.size(); ++i) {
      run.samples[i].command_m_s = sent[std::min(i + rows, sent.size() - 1)].command_m_s;
    }
  }
  return runs;
}

std::vector<DriveLog> left_wheel_stronger(std::vector<DriveLog> runs, double gain) {
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) sample.command_m_s.left /= gain;
  }
  return runs;
}

const LinearChange* change_of(const GapAnalysis& analysis, std::string_view what, std::string_view wheel) {
  const auto found = std::ranges::find_if(analysis.linear_changes, [&](const LinearChange& change) {
    return change.what == what && change.wheel == wheel;
  });
  return found == analysis.linear_changes.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("A corrected linear part has the gain and the lag that were asked for, and commands their delay") {
  LinearModel model;
  model.type = ModelType::arma;
  model.period_s = 0.02;
  const double pole = std::exp(-model.period_s / 0.1);
  model.left = {{0.0, 1.0 - pole}, {}, {pole}};
  model.right = {{}, {0.0, 1.0 - pole}, {pole}};
  const auto answer = [](const LinearModel& of, int periods) {
    LinearPredictor predictor(of);
    std::vector<double> left;
    for (int k = 0; k < periods; ++k) left.push_back(predictor.step({0.2, 0.1}).left);
    return left;
  };
  const auto stronger = corrected(model, {{1.1, 1.0}, 0.0, 0.0});
  CHECK_THAT(dc_gain(stronger.left).from_left, WithinRel(1.1, 1e-9));
  CHECK_THAT(dc_gain(stronger.right).from_right, WithinRel(1.0, 1e-9));
  const auto usual = answer(model, 200);
  const auto lagging = answer(corrected(model, {{1.0, 1.0}, 0.0, 0.1}), 200);
  double missing_s = 0.0;  // area between the two answers: what the mean delay grew by
  for (std::size_t k = 0; k < usual.size(); ++k) missing_s += model.period_s * (usual[k] - lagging[k]) / 0.2;
  CHECK_THAT(missing_s, WithinAbs(0.1, 0.015));

  std::vector<WheelPair> step(400);
  std::fill(step.begin() + 50, step.end(), WheelPair{0.2, 0.1});
  const auto late = delayed(step, 0.05, model.period_s);
  CHECK(late[51].left == 0.0);
  CHECK_THAT(late[52].left, WithinRel(0.1, 1e-9));  // half a period remains of the delay
  CHECK_THAT(delayed(step, -0.04, model.period_s)[48].left, WithinRel(0.2, 1e-9));
}

TEST_CASE("A model of the robot itself has no linear change") {
  const auto analysis = analysed(robot().runs, {.model = robot().model});
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK(analysis.linear_changes.empty());
}

TEST_CASE("A given model that is too quick is told by how much, and the delay is named") {
  const std::size_t rows = GENERATE(std::size_t{3}, std::size_t{8});
  const auto& runs = robot().runs;
  const auto analysis = analysed(later(runs, rows), {.model = robot().model});
  const double true_s = static_cast<double>(rows) * runs.front().period_s;
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::named);
  REQUIRE_FALSE(analysis.found.empty());
  CHECK(analysis.found.front().setting.name == "transport_delay");
  const LinearChange* delay = change_of(analysis, "delay", "both");
  REQUIRE(delay != nullptr);
  CHECK_THAT(delay->value, WithinAbs(true_s, 0.0036));
  CHECK(analysis.test.after.distance_rms_m < 0.3 * analysis.test.before.distance_rms_m.value());
}

TEST_CASE("A gain that a given model has wrong is told for its wheel, and is never nothing") {
  const auto analysis = analysed(left_wheel_stronger(robot().runs, 1.03), {.model = robot().model});
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::unnamed);
  const LinearChange* gain = change_of(analysis, "gain", "left");
  REQUIRE(gain != nullptr);
  CHECK_THAT(gain->value, WithinAbs(1.03, 0.004));
  CHECK(gain->interval.lower > 1.02);
  CHECK(gain->interval.upper < 1.04);
  CHECK(change_of(analysis, "gain", "right") == nullptr);
  CHECK_THAT(analysis.summary, ContainsSubstring("the gain of the left wheel is 1.03"));
}

// What acts of each command is what is left of it beyond a threshold.
std::vector<DriveLog> beyond(std::vector<DriveLog> runs, double threshold_m_s) {
  const auto lift = [&](double& command) {
    if (command != 0.0) command += std::copysign(threshold_m_s, command);
  };
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      lift(sample.command_m_s.left);
      lift(sample.command_m_s.right);
    }
  }
  return runs;
}

TEST_CASE("Gains that the taper of a dead zone stands for as well are no change of the linear part") {
  RobotModel given = robot().model;
  given.effects.push_back({{"dead_zone", "", {0.03, 0.93}}, {}, {}, {}, {}, {}});
  const auto analysis = analysed(beyond(robot().runs, 0.03), {.model = given});
  INFO(analysis.summary);
  CHECK(change_of(analysis, "gain", "left") == nullptr);
  CHECK(change_of(analysis, "gain", "right") == nullptr);
}

TEST_CASE("A given model of another period is not compared with the logs, and the summary says so") {
  RobotModel other = robot().model;
  other.linear_part.period_s = 0.02;
  const GapAnalysis analysis = analysed(robot().runs, {.model = other});
  CHECK(analysis.linear_changes.empty());
  CHECK_THAT(analysis.summary, ContainsSubstring("period is 0.02 s and that of the logs 0.03 s"));
}
