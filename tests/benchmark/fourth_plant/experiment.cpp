#include "tests/benchmark/fourth_plant/experiment.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/benchmark/fourth_plant/delay_line.hpp"
#include "tests/benchmark/fourth_plant/plant.hpp"
#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/plants/reference.hpp"

namespace plants::fourth {

namespace {

// Row instants scatter, and the log says when they were.
long instant_steps(long row, const Robot& robot, Random& random) {
  const double nominal_s = static_cast<double>(row) * robot.period_s;
  if (row == 0) return 0;
  return std::lround((nominal_s + random.normal(robot.jitter_s)) / fine_step_s);
}

Pose start_pose(Random& random) {
  return {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
          random.uniform(-std::numbers::pi, std::numbers::pi)};
}

class Recorder {
 public:
  Recorder(const Experiment& experiment, std::size_t rows, const Pose& start, const Random& random)
      : robot_(experiment.robot),
        reference_(experiment.sensors, robot_.period_s, rows, random.child(0)),
        volts_random_(random.child(1)),
        seen_(steps_in(robot_.reference_latency_s, fine_step_s), marker(start)) {
    constexpr int tenths_of_millimetres = 4;
    run_.log.wheel_base_m = robot_.wheel_base_m;
    run_.log.period_s = robot_.period_s;
    run_.log.metres_per_tick = robot_.metres_per_tick;
    run_.log.digits.command = tenths_of_millimetres;
  }

  void watch(const Plant& plant) { seen_.step(marker(plant.pose())); }

  void note(const Plant& plant, const PerWheel<double>& command_m_s) {
    LogRow row;
    row.time_s = plant.time_s();
    row.command_m_s = command_m_s;
    row.ticks = plant.ticks();
    row.reference = reference_.look(static_cast<long>(run_.log.rows.size()), seen_.oldest());
    row.battery_v = plant.battery_v() + volts_random_.normal(robot_.battery.noise_v);
    run_.log.rows.push_back(row);
    run_.truth.push_back({marker(plant.pose()), plant.pose().heading_rad});
  }

  [[nodiscard]] Run take() { return std::move(run_); }

 private:
  [[nodiscard]] Pose marker(const Pose& axle) const {
    return point_of_body(axle, robot_.marker_x_m, robot_.marker_y_m);
  }

  Robot robot_;
  Reference reference_;
  Random volts_random_;
  DelayLine<Pose> seen_;
  Run run_;
};

Run drive_once(const Experiment& experiment, int index) {
  constexpr double shortest_s = 40.0;
  constexpr double longest_s = 60.0;
  const Robot& robot = experiment.robot;
  const Random random = Random(experiment.seed).child(static_cast<std::uint64_t>(index));
  Random set_up = random.child(0);
  const Pose start = start_pose(set_up);
  const std::vector<PerWheel<double>> commands =
      make_commands(experiment.programme, experiment.limits, robot.period_s,
                    set_up.uniform(shortest_s, longest_s), random.child(1));
  Plant plant(robot, start, robot.battery.full_v - robot.battery.fall_between_v * index, random.child(2));
  Recorder recorder(experiment, commands.size(), start, random.child(3));
  for (std::size_t row = 0; row < commands.size(); ++row) {
    recorder.note(plant, commands[row]);
    const long next_steps = instant_steps(static_cast<long>(row) + 1, robot, set_up);
    while (std::lround(plant.time_s() / fine_step_s) < next_steps) {
      plant.step(commands[row]);
      recorder.watch(plant);
    }
  }
  return recorder.take();
}

}  // namespace

std::vector<Run> drive(const Experiment& experiment) {
  std::vector<Run> runs;
  runs.reserve(runs_of_a_case);
  for (int index = 0; index < runs_of_a_case; ++index) runs.push_back(drive_once(experiment, index));
  return runs;
}

}  // namespace plants::fourth
