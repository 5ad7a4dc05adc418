#include "tests/benchmark/third_plant/run.hpp"

#include <algorithm>
#include <vector>

#include "tests/benchmark/plants/reference.hpp"
#include "tests/benchmark/third_plant/episodes.hpp"
#include "tests/benchmark/third_plant/plant.hpp"

namespace plants::third {

namespace {

constexpr LogDigits logger_digits{.time = 4, .command = 4, .pose = 4, .battery = 2};

// When the rows of a run are taken.
std::vector<double> row_times_s(const RobotSpec& robot, double duration_s, Random random) {
  constexpr double min_share = 0.3;
  std::vector<double> times_s(static_cast<std::size_t>(duration_s / robot.period_s), 0.0);
  for (std::size_t row = 1; row < times_s.size(); ++row) {
    const double due_s = static_cast<double>(row) * robot.period_s;
    times_s[row] =
        std::max(times_s[row - 1] + min_share * robot.period_s, due_s + random.normal(robot.jitter_s));
  }
  return times_s;
}

}  // namespace

Run drive_run(const RobotSpec& robot, const SensorSet& sensors, const Outing& outing,
              const Commander& commander, const Random& random) {
  const std::vector<double> times_s = row_times_s(robot, outing.duration_s, random.child(0));
  Plant plant(robot, outing.run, outing.duration_s, outing.start, random.child(1));
  Reference reference(sensors, robot.period_s, times_s.size(), random.child(2));
  Random voltmeter = random.child(3);
  const Episodes dropouts(robot.encoder.dropouts, outing.duration_s, random.child(4));
  PerWheel<Encoder> encoders{Encoder(robot.encoder, random.child(5)),
                             Encoder(robot.encoder, random.child(6))};

  Run run{{robot.wheel_base_m, robot.period_s, robot.encoder.metres_per_tick, logger_digits, {}}, {}};
  for (std::size_t index = 0; index < times_s.size(); ++index) {
    const double now_s = times_s[index];
    plant.advance_to(now_s);
    LogRow row;
    row.time_s = now_s;
    for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
      row.ticks[wheel] = encoders[wheel].read(plant.wheel_travel_m(wheel), dropouts.hit(wheel, now_s));
    const Pose marker = point_of_body(plant.pose(), robot.marker_x_m, robot.marker_y_m);
    row.reference = reference.look(static_cast<long>(index), marker);
    row.battery_v = plant.terminal_v() + voltmeter.normal(robot.supply.noise_v);
    row.command_m_s = commander(index, now_s, plant.pose());
    plant.receive(row.command_m_s);
    run.log.rows.push_back(row);
    run.truth.push_back({marker, marker.heading_rad});
  }
  return run;
}

}  // namespace plants::third
