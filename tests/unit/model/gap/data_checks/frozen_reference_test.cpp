// References that stand still while the wheels roll.
#include <cmath>
#include <random>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// With a reference on every row that saw what the counts say.
DriveLog referenced_log() {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 40.0;
  DriveLog log = test::make_gap_case(spec).runs.front();
  Pose pose;
  const DriveSample* before = nullptr;
  for (auto& sample : log.samples) {
    if (before != nullptr) {
      const double left =
          log.metres_per_tick->left * static_cast<double>(sample.ticks->left - before->ticks->left);
      const double right =
          log.metres_per_tick->right * static_cast<double>(sample.ticks->right - before->ticks->right);
      const double turn = (right - left) / log.wheel_base_m;
      pose.x_m += 0.5 * (left + right) * std::cos(pose.theta_rad + 0.5 * turn);
      pose.y_m += 0.5 * (left + right) * std::sin(pose.theta_rad + 0.5 * turn);
      pose.theta_rad += turn;
    }
    sample.reference_x_m = pose.x_m;
    sample.reference_y_m = pose.y_m;
    sample.reference_theta_rad = pose.theta_rad;
    before = &sample;
  }
  return log;
}

// From a row on it repeats its pose, with noise of that size.
void freeze(DriveLog& log, std::size_t from, std::size_t to, double noise_m = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  const DriveSample last = log.samples[from];
  for (std::size_t i = from + 1; i < to; ++i) {
    auto& sample = log.samples[i];
    sample.reference_x_m = *last.reference_x_m + noise_m * noise(random);
    sample.reference_y_m = *last.reference_y_m + noise_m * noise(random);
    sample.reference_theta_rad = *last.reference_theta_rad + noise_m * noise(random);
  }
}

bool says(const GatedLog& gated, const std::string& what, bool explains) {
  for (const auto& fault : gated.faults) {
    if (fault.what.find(what) != std::string::npos && fault.explains == explains) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("A reference that follows the wheels, also at a low rate, is not frozen") {
  DriveLog log = referenced_log();
  CHECK_FALSE(says(gate(log), "stands still", false));
  DriveSample held = log.samples.front();
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    auto& sample = log.samples[i];
    if (i % 20 == 0) held = sample;
    sample.reference_x_m = held.reference_x_m;
    sample.reference_y_m = held.reference_y_m;
    sample.reference_theta_rad = held.reference_theta_rad;
  }
  CHECK_FALSE(says(gate(log), "stands still", false));
}

TEST_CASE("A reference that hangs for a while is named with its row, and its poses are left out") {
  for (const double noise_m : {0.0, 0.0003}) {
    INFO(noise_m);
    DriveLog log = referenced_log();
    const std::size_t from = log.samples.size() / 3;
    const std::size_t to = log.samples.size() / 2;
    freeze(log, from, to, noise_m);
    const GatedLog gated = gate(log);
    CHECK(says(gated, "the reference stands still while the wheels roll", false));
    CHECK_FALSE(says(gated, "frozen", true));
    CHECK_FALSE(gated.log.samples[(from + to) / 2].reference_x_m);
    CHECK(gated.log.samples[from / 2].reference_x_m);
    CHECK(gated.log.samples[(to + log.samples.size()) / 2].reference_x_m);
  }
}

TEST_CASE("A reference that hangs for most of a run explains any gap") {
  DriveLog log = referenced_log();
  freeze(log, log.samples.size() / 10, log.samples.size(), 0.0002);
  CHECK(says(gate(log), "it is frozen, or the robot was held", true));
}

TEST_CASE("A heading that does not turn with the wheels explains any gap") {
  DriveLog log = referenced_log();
  for (auto& sample : log.samples) sample.reference_theta_rad = 0.3;
  CHECK(says(gate(log), "the heading of the reference does not turn", true));
  for (auto& sample : log.samples) {
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
  }
  CHECK(says(gate(log), "it is frozen", true));
}

TEST_CASE("First and last pose alone do not say that a heading is frozen, though whole turns bring it back") {
  DriveLog log = referenced_log();
  const DriveSample first = log.samples.front();
  for (auto& sample : log.samples)
    sample.reference_x_m = sample.reference_y_m = sample.reference_theta_rad = {};
  auto& start = log.samples.front();
  auto& end = log.samples.back();
  start.reference_x_m = start.reference_y_m = start.reference_theta_rad = 0.0;
  end.reference_x_m = *first.reference_x_m + 1.0;
  end.reference_y_m = 0.0;
  end.reference_theta_rad = 0.002;
  CHECK_FALSE(says(gate(log), "the heading of the reference does not turn", true));
}
