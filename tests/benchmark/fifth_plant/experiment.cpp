#include "tests/benchmark/fifth_plant/experiment.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/benchmark/fifth_plant/tracker.hpp"
#include "tests/benchmark/fifth_plant/vehicle.hpp"
#include "tests/benchmark/plants/reference.hpp"

namespace plants::fifth {

namespace {

class Recorder {
 public:
  Recorder(const Experiment& experiment, std::size_t rows, const Random& random)
      : robot_(experiment.robot),
        reference_(experiment.sensors, robot_.period_s, rows, random.child(0)),
        random_(random.child(1)) {
    run_.log.wheel_base_m = robot_.said_wheel_base_m;
    run_.log.period_s = robot_.period_s;
    run_.log.metres_per_tick = robot_.encoder.metres_per_tick;
  }

  void note(double time_s, const Vehicle& vehicle, const Tracker& tracker, const PerWheel<double>& command) {
    const long row_number = static_cast<long>(run_.log.rows.size());
    LogRow row;
    row.time_s = row_number == 0 ? 0.0 : time_s + random_.normal(robot_.stamp_noise_s);
    row.command_m_s = command;
    row.ticks = vehicle.ticks();
    row.reference = reference_.look(row_number, tracker.seen());
    row.battery_v = vehicle.battery_v() + random_.normal(robot_.battery.noise_v);
    run_.log.rows.push_back(row);
    const Pose& axle = vehicle.motion().pose;
    run_.truth.push_back({tracker.marker(axle), tracker.shown_rad(axle.heading_rad)});
  }

  [[nodiscard]] Run take() { return std::move(run_); }

 private:
  Robot robot_;
  Reference reference_;
  Random random_;
  Run run_;
};

// Rows come a little early or late.
std::vector<long> row_instants(const Robot& robot, double duration_s, Random& random) {
  const long rows = std::lround(duration_s / robot.period_s);
  std::vector<long> instants;
  for (long row = 0; row < rows; ++row) {
    const double late_s = row == 0 ? 0.0 : random.normal(robot.jitter_s);
    instants.push_back(std::lround((static_cast<double>(row) * robot.period_s + late_s) / fine_step_s));
  }
  return instants;
}

Run drive_once(const Experiment& experiment, int index, const Run* driven) {
  constexpr double shortest_s = 46.0;
  constexpr double longest_s = 80.0;
  const Robot& robot = experiment.robot;
  const auto stream = static_cast<std::uint64_t>(index);
  const Random random = Random(experiment.seed).child(stream);
  const Random noise = Random(experiment.noise_seed).child(stream);
  Random set_up = random.child(0);
  const double duration_s = set_up.uniform(shortest_s, longest_s);
  const Pose start{set_up.uniform(-0.5, 0.5), set_up.uniform(-0.5, 0.5),
                   set_up.uniform(-std::numbers::pi, std::numbers::pi)};
  const std::vector<long> instants = row_instants(robot, duration_s, set_up);
  Person person(experiment.programme, experiment.style, robot.period_s, duration_s, random.child(1));
  Vehicle vehicle(robot, start, robot.battery.full_v - robot.battery.fall_between_v * index, noise.child(0));
  Tracker tracker(robot.tracker, start, noise.child(1));
  Recorder recorder(experiment, instants.size(), noise.child(2));
  long steps = 0;
  for (std::size_t row = 0; row < instants.size(); ++row) {
    const double time_s = fine_step_s * static_cast<double>(instants[row]);
    const PerWheel<double> command =
        driven != nullptr ? driven->log.rows[row].command_m_s : person.command(time_s, vehicle.motion().pose);
    recorder.note(time_s, vehicle, tracker, command);
    const long end = row + 1 < instants.size() ? instants[row + 1] : steps;
    for (; steps < end; ++steps) {
      vehicle.step(command);
      tracker.step(vehicle.motion().pose);
    }
  }
  return recorder.take();
}

}  // namespace

std::vector<Run> drive(const Experiment& experiment) {
  std::vector<Run> runs;
  for (int index = 0; index < experiment.runs; ++index)
    runs.push_back(drive_once(experiment, index, nullptr));
  return runs;
}

std::vector<Run> drive_again(const Experiment& experiment, const std::vector<Run>& driven) {
  std::vector<Run> runs;
  for (int index = 0; index < experiment.runs; ++index)
    runs.push_back(drive_once(experiment, index, &driven[static_cast<std::size_t>(index)]));
  return runs;
}

}  // namespace plants::fifth
