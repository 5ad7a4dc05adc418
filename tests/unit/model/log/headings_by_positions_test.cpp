#include "model/log/headings_by_positions.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.1;
constexpr double wheel_base_m = 0.45;
constexpr double metres_per_tick = 1e-3;

// A robot with a marker that a receiver follows, ahead of its axle and left of it.
struct MarkedRobot {
  double noise_m = 0.015;
  Pose marker = {};
  double wheel_base_m = ::wheel_base_m;  // in truth
  double scale = 1.0;                    // of its travel, beyond what is counted
  double yaw_bias_rad_s = 0.0;
};

struct Drive {
  DriveLog log;
  std::vector<double> heading_rad;
};

// Arcs, straights and turns on the spot.
WheelPair speed_at(double time_s) {
  const int phase = static_cast<int>(time_s / 3.0) % 5;
  if (phase == 1) return {0.5, 0.2};
  if (phase == 3) return {-0.25, 0.25};
  if (phase == 4) return {-0.3, -0.3};
  return {0.4, 0.4};
}

Drive driven(const MarkedRobot& robot, unsigned seed, int rows = 900) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0.0, robot.noise_m);
  Drive drive;
  drive.log.wheel_base_m = wheel_base_m;
  drive.log.period_s = period_s;
  drive.log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  Pose pose{3.0, -2.0, 2.0};
  WheelPair counted_m;
  for (int row = 0; row < rows; ++row) {
    const Pose seen = compose(pose, robot.marker);
    DriveSample sample;
    sample.t_s = period_s * row;
    sample.command_m_s = speed_at(sample.t_s);
    sample.ticks = WheelTicks{std::llround(counted_m.left / metres_per_tick),
                              std::llround(counted_m.right / metres_per_tick)};
    sample.reference_x_m = seen.x_m + noise(engine);
    sample.reference_y_m = seen.y_m + noise(engine);
    drive.log.samples.push_back(sample);
    drive.heading_rad.push_back(pose.theta_rad);
    const WheelPair speed = sample.command_m_s;
    counted_m.left += speed.left * period_s;
    counted_m.right += speed.right * period_s;
    Twist twist = twist_of_wheels({robot.scale * speed.left, robot.scale * speed.right}, robot.wheel_base_m);
    twist.w_rad_s += robot.yaw_bias_rad_s;
    pose = move_along_arc(pose, twist, period_s);
  }
  return drive;
}

struct HeadingErrors {
  double mean_rad = 0.0;
  double rms_rad = 0.0;
};

HeadingErrors errors_of(const Drive& drive) {
  HeadingErrors errors;
  const auto& samples = drive.log.samples;
  const auto has_heading = [](const DriveSample& sample) { return sample.reference_theta_rad.has_value(); };
  const auto count = static_cast<double>(std::ranges::count_if(samples, has_heading));
  for (std::size_t row = 0; row < drive.heading_rad.size(); ++row) {
    if (!has_heading(samples[row])) continue;
    const double error_rad = wrap_angle(*samples[row].reference_theta_rad - drive.heading_rad[row]);
    errors.mean_rad += error_rad / count;
    errors.rms_rad += error_rad * error_rad / count;
  }
  errors.rms_rad = std::sqrt(errors.rms_rad);
  return errors;
}

}  // namespace

TEST_CASE("Headings of positions alone are found from the counts, about as well as is said") {
  Drive drive = driven({}, 1);
  const auto found = find_headings(drive.log);
  REQUIRE(found);
  CHECK_THAT(found->position_m, WithinRel(0.015, 0.25));
  CHECK(found->heading_rad < 0.06);
  CHECK(errors_of(drive).rms_rad < 1.5 * found->heading_rad);
}

TEST_CASE("Neither a marker beside the axle nor wrong counts turn the headings that are found") {
  const auto robots = {MarkedRobot{.marker = {0.3, 0.1, 0.0}},
                       MarkedRobot{.wheel_base_m = 1.06 * wheel_base_m}, MarkedRobot{.scale = 1.05},
                       MarkedRobot{.yaw_bias_rad_s = 0.03}};
  for (const MarkedRobot& robot : robots) {
    CAPTURE(robot.marker.x_m, robot.wheel_base_m, robot.scale, robot.yaw_bias_rad_s);
    Drive drive = driven(robot, 2);
    REQUIRE(find_headings(drive.log));
    CHECK(std::abs(errors_of(drive).mean_rad) < 0.02);
    CHECK(errors_of(drive).rms_rad < 0.08);
  }
}

TEST_CASE("Positions once a second show the heading as well") {
  Drive drive = driven({}, 3);
  for (std::size_t row = 0; row < drive.log.samples.size(); ++row) {
    if (row % 10 == 0) continue;
    drive.log.samples[row].reference_x_m.reset();
    drive.log.samples[row].reference_y_m.reset();
  }
  const auto found = find_headings(drive.log);
  REQUIRE(found);
  CHECK(found->heading_rad < 0.1);
  CHECK_FALSE(drive.log.samples[1].reference_theta_rad);
}

TEST_CASE("A position that is repeated until a new one comes is one position") {
  Drive drive = driven({}, 6);
  auto& samples = drive.log.samples;
  for (std::size_t row = 0; row < samples.size(); ++row) {
    samples[row].reference_x_m = samples[row - row % 10].reference_x_m;
    samples[row].reference_y_m = samples[row - row % 10].reference_y_m;
  }
  const auto found = find_headings(drive.log);
  REQUIRE(found);
  CHECK_THAT(found->position_m, WithinRel(0.015, 0.4));
  CHECK(errors_of(drive).rms_rad < 2.0 * found->heading_rad);
}

TEST_CASE("Where nothing shows the headings the log stays as it is") {
  Drive at_rest = driven({}, 4);
  for (DriveSample& sample : at_rest.log.samples) sample.ticks = WheelTicks{};
  Drive without_counts = driven({}, 4);
  without_counts.log.metres_per_tick.reset();
  for (DriveSample& sample : without_counts.log.samples) sample.ticks.reset();
  for (Drive* drive : {&without_counts, &at_rest}) {
    CHECK_FALSE(find_headings(drive->log));
    CHECK_FALSE(drive->log.samples.back().reference_theta_rad);
  }
  Drive measured = driven({}, 5);
  measured.log.samples.front().reference_theta_rad = 0.5;
  CHECK_FALSE(find_headings(measured.log));
}
