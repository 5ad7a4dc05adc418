// The calibration that never ends, on drives of the simulated robot.
#include "model/adaptation/continuous_calibration.hpp"

#include <array>
#include <cmath>
#include <random>

#include "tests/support/catch.hpp"
#include "tests/support/outdated_model.hpp"
#include "tests/support/recorded_drive.hpp"

using namespace wheelwright;

namespace {

const RobotModel& calibrated() {
  static const RobotModel made = test::calibrated_model("default", "box", 61);
  return made;
}

RobotModel outdated(double factor) {
  return test::scaled(calibrated(), factor);
}

const std::vector<SensorFrame>& drive() {
  static const auto made = test::record_drive(test::robot_on_endless_floor("default", 71), 71, 150.0).frames;
  return made;
}

constexpr std::size_t carpet_from = 2500;

// From linoleum onto a carpet.
const std::vector<SensorFrame>& drive_onto_carpet() {
  static const auto change = [](simulation::SimulatedRobot& robot, int tick) {
    if (tick != static_cast<int>(carpet_from)) return;
    robot.inject(
        {.kind = simulation::Fault::Kind::change_floor,
         .surface = {.grip = 0.55, .creep_per_n = 0.006, .rolling_drag = 0.03, .scrub_factor = 8.0}});
  };
  static const auto made =
      test::record_drive(test::robot_on_endless_floor("default", 63), 63, 150.0, change).frames;
  return made;
}

}  // namespace

TEST_CASE(
    "Driving straight corrects what it shows and leaves the rest, and standing for an hour shows nothing") {
  // Both wheels roll 3 % further than the model says.
  for (const double speed_m_s : {0.0, 0.2}) {
    ModelAdaptation adaptation(calibrated(), ModelSimulation(calibrated()));
    const auto gain_of = [](const RobotModel& model) { return dc_gain(model.linear_part.left).from_left; };
    SensorFrame frame = drive().back();
    frame.command.speed_m_s = {speed_m_s, speed_m_s};
    double travelled_m = 0.0;
    const WheelTicks start = frame.ticks;
    for (int k = 0; k < 200000; ++k) {
      adaptation.take(frame, true);
      ++frame.tick;
      travelled_m += 0.018 * 1.03 * gain_of(calibrated()) * speed_m_s;
      const auto counts = std::llround(travelled_m / calibrated().encoder_scale->metres_per_tick.left);
      frame.ticks = {start.left + counts, start.right + counts};
    }
    INFO(speed_m_s << " m/s");
    if (speed_m_s == 0.0) CHECK(adaptation.size() < 200);
    const RobotModel adapted = adaptation.adapted();
    CHECK_THAT(gain_of(adapted) / gain_of(calibrated()), WithinAbs(speed_m_s > 0.0 ? 1.03 : 1.0, 0.002));
    // One speed does not tell gain, delay and lag apart: the prior shares the change among the three.
    const auto& before = calibrated().linear_part.left.from_left;
    const auto after = adapted.linear_part.left.from_left;
    for (std::size_t i = 0; i < before.size(); ++i) CHECK_THAT(after[i], WithinAbs(before[i], 0.01));
  }
}

TEST_CASE(
    "Once due, a model that is wrong by 7 per cent is replaced by one whose free run is better on driving "
    "not seen") {
  const RobotModel wrong = outdated(0.93);
  ContinuousCalibration calibration(wrong);
  std::optional<RobotModel> better;
  for (const SensorFrame& frame : drive_onto_carpet()) {
    if (auto found = calibration.take(frame); found && !better) better = found;
  }
  REQUIRE(better);
  CHECK(better->linear_part.type == wrong.linear_part.type);

  // On another drive altogether.
  const auto other = test::record_drive(test::robot_on_endless_floor("default", 72), 72, 40.0).frames;
  ModelTrial trial(wrong, *better);
  for (const SensorFrame& frame : other) trial.take(frame, true);
  CHECK(trial.is_better());
  CHECK(*trial.candidate_error_m() < 0.5 * *trial.present_error_m());
}

TEST_CASE("A candidate that was made from corrupted data is not accepted") {
  // What it learns from is wrong by a fifth, what it is judged on is right.
  ModelAdaptation adaptation(calibrated(), ModelSimulation(calibrated()));
  for (SensorFrame frame : drive()) {
    frame.ticks.left = frame.ticks.left * 6 / 5;
    adaptation.take(frame, true);
  }
  ModelTrial trial(calibrated(), adaptation.adapted());
  for (const SensorFrame& frame : drive()) trial.take(frame, true);
  CHECK(trial.blocks() > 10);
  CHECK_FALSE(trial.is_better());
}

TEST_CASE("A candidate that is worse on driving that it has not seen is never handed out") {
  // While it is made both encoders count a seventh too much, and no longer once it is judged.
  ContinuousCalibration calibration(outdated(0.93));
  WheelTicks last;
  std::array<double, 2> added{};
  int trials = 0;
  for (SensorFrame frame : drive()) {
    const auto before = calibration.phase();
    if (frame.valid && before == ContinuousCalibration::Phase::adapt) {
      added[0] += static_cast<double>(frame.ticks.left - last.left) / 7.0;
      added[1] += static_cast<double>(frame.ticks.right - last.right) / 7.0;
    }
    if (frame.valid) last = frame.ticks;
    frame.ticks.left += std::llround(added[0]);
    frame.ticks.right += std::llround(added[1]);
    CHECK_FALSE(calibration.take(frame));
    if (before == ContinuousCalibration::Phase::judge && calibration.phase() != before) ++trials;
  }
  CHECK(trials > 0);
}

TEST_CASE(
    "A correction of a correction for ever does not make the response longer for ever, and keeps its gain") {
  RobotModel model = outdated(0.93);
  for (int k = 0; k < 60; ++k) {
    ModelAdaptation adaptation(model, ModelSimulation(model));
    for (std::size_t i = 0; i < 600; ++i) adaptation.take(drive()[i], true);
    model = adaptation.adapted();
  }
  CHECK(model.linear_part.left.from_left.size() == 100);
  CHECK_THAT(dc_gain(model.linear_part.left).from_left / dc_gain(calibrated().linear_part.left).from_left,
             WithinAbs(1.0, 0.02));
}

TEST_CASE("While a fault is there nothing is learnt") {
  ModelAdaptation adaptation(calibrated(), ModelSimulation(calibrated()));
  for (const SensorFrame& frame : drive()) adaptation.take(frame, false);
  CHECK_THAT(dc_gain(adaptation.adapted().linear_part.left).from_left,
             WithinAbs(dc_gain(calibrated().linear_part.left).from_left, 1e-9));
}

// The robot's own speed controller hides the floor from the counts: the model is due by the motor currents,
// and is still as good as any candidate.
TEST_CASE("On a carpet the model is due within 5 s, and only a better one replaces it") {
  ContinuousCalibration calibration(calibrated());
  std::optional<std::size_t> due;
  int trials = 0;
  for (std::size_t k = 0; k < drive_onto_carpet().size(); ++k) {
    const auto before = calibration.phase();
    const bool swapped = calibration.take(drive_onto_carpet()[k]).has_value();
    const auto phase = calibration.phase();
    if (phase == ContinuousCalibration::Phase::adapt && !due) due = k;
    if (before == ContinuousCalibration::Phase::judge && phase != before) ++trials;
    if (swapped) CHECK(*calibration.trial()->candidate_error_m() < *calibration.trial()->present_error_m());
  }
  REQUIRE(due);
  CHECK(*due >= carpet_from);
  CHECK(0.018 * static_cast<double>(*due - carpet_from) < 5.0);
  CHECK(trials > 0);
}
