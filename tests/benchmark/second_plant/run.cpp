#include "tests/benchmark/second_plant/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/plants/reference.hpp"
#include "tests/benchmark/second_plant/encoder.hpp"
#include "tests/benchmark/second_plant/plant.hpp"

namespace plants::second {

namespace {

Pose start_pose(Random random, bool keep_heading) {
  const double heading_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
  return {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
          keep_heading ? kKeptHeading_rad : heading_rad};
}

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
  Run run{{robot.body.nominal_track_m, robot.period_s, metres_per_tick, {}, {}}, {}};
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
    truth.reference_point = point_of_body(plant.pose(), robot.reference_x_m, robot.reference_y_m);
    truth.heading_rad = plant.pose().heading_rad;
    row.reference = reference.look(static_cast<long>(index), truth.reference_point);
    row.battery_v = plant.terminal_v() + volts.normal(robot.battery.noise_v);
    plant.receive(programme[index]);
    run.log.rows.push_back(row);
    run.truth.push_back(truth);
  }
  return run;
}

}  // namespace plants::second
