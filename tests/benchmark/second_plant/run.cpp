#include "tests/benchmark/second_plant/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/second_plant/encoder.hpp"

namespace second_plant {

namespace {

double wrapped_rad(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

Pose start_pose(Random random, bool keep_heading) {
  const double heading_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
  return {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
          keep_heading ? kKeptHeading_rad : heading_rad};
}

Pose reference_point(const RobotSpec& robot, const Pose& axle) {
  const double cosine = std::cos(axle.heading_rad);
  const double sine = std::sin(axle.heading_rad);
  return {axle.x_m + cosine * robot.reference_x_m - sine * robot.reference_y_m,
          axle.y_m + sine * robot.reference_x_m + cosine * robot.reference_y_m, axle.heading_rad};
}

// The outside reference: noise on every axis, heading within one turn.
class Reference {
 public:
  Reference(const SensorSet& sensors, double period_s, std::size_t rows, Random random)
      : sensors_(sensors),
        random_(random),
        every_(std::max(1L, std::lround(sensors.pose_every_s / period_s))),
        last_row_(static_cast<long>(rows) - 1) {}

  std::optional<Pose> look(long row, const Pose& truth) {
    const Pose seen{truth.x_m + random_.normal(sensors_.position_noise_m),
                    truth.y_m + random_.normal(sensors_.position_noise_m),
                    wrapped_rad(truth.heading_rad + random_.normal(sensors_.heading_noise_rad))};
    const bool at_end = row == 0 || row == last_row_;
    const bool due = !sensors_.only_end_poses && row % every_ == 0;
    if (at_end || due) return seen;
    return std::nullopt;
  }

 private:
  SensorSet sensors_;
  Random random_;
  long every_;
  long last_row_;
};

}  // namespace

Run drive_run(const RobotSpec& robot, const SensorSet& sensors, const Programme& programme, int run_index,
              bool keep_heading, const Random& random) {
  constexpr double kLoopJitter_s = 0.0003;
  constexpr double kStampJitter_s = 0.0002;
  const double duration_s = robot.period_s * static_cast<double>(programme.size());
  Plant plant(robot, run_index, start_pose(random.child(1), keep_heading), random.child(2));
  Random jitter = random.child(3);
  Random volts = random.child(4);
  Reference reference(sensors, robot.period_s, programme.size(), random.child(5));
  PerWheel<Encoder> encoders{Encoder(robot.encoder, duration_s, random.child(6)),
                             Encoder(robot.encoder, duration_s, random.child(7))};

  const double metres_per_tick =
      2.0 * std::numbers::pi * robot.tyre[left_side].radius_m / robot.encoder.ticks_per_turn;
  Run run{{robot.body.nominal_track_m, robot.period_s, metres_per_tick, {}}, {}};
  for (std::size_t index = 0; index < programme.size(); ++index) {
    const double event_s =
        robot.period_s * static_cast<double>(index) + std::abs(jitter.normal(kLoopJitter_s));
    plant.advance_to(event_s);
    LogRow row;
    row.time_s = index == 0 ? 0.0 : event_s + std::clamp(jitter.normal(kStampJitter_s), -0.001, 0.001);
    row.command_m_s = programme[index];
    TrueRow truth;
    for (std::size_t wheel = 0; wheel < wheel_count; ++wheel) {
      row.ticks[wheel] = encoders[wheel].read(event_s, plant.wheel_angle_rad(wheel));
    }
    truth.reference_point = reference_point(robot, plant.pose());
    truth.heading_rad = plant.pose().heading_rad;
    row.reference = reference.look(static_cast<long>(index), truth.reference_point);
    row.battery_v = plant.terminal_v() + volts.normal(robot.battery.noise_v);
    plant.receive(programme[index]);
    run.log.rows.push_back(row);
    run.truth.push_back(truth);
  }
  return run;
}

}  // namespace second_plant
