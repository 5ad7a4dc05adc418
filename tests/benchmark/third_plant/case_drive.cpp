#include "tests/benchmark/third_plant/case_drive.hpp"

#include <numbers>

#include "tests/benchmark/third_plant/driver.hpp"
#include "tests/benchmark/third_plant/run.hpp"

namespace plants::third {

namespace {

Random stream_of_run(const Case& item, int run) {
  return Random(item.seed).child(static_cast<std::uint64_t>(run));
}

Outing random_outing(const Case& item, int run) {
  Random random = stream_of_run(item, run).child(0);
  Outing outing;
  outing.run = run;
  outing.duration_s = random.uniform(60.0, 90.0);
  outing.start.x_m = item.habits.room_x_m + random.uniform(-0.4, 0.4);
  outing.start.y_m = item.habits.room_y_m + random.uniform(-0.4, 0.4);
  outing.start.heading_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
  return outing;
}

Run drive_once(const Case& item, const RobotSpec& robot, const Outing& outing, const Commander& commander) {
  return drive_run(robot, item.sensors, outing, commander, stream_of_run(item, outing.run).child(1));
}

}  // namespace

std::vector<Run> drive(const Case& item) {
  std::vector<Run> runs;
  for (int run = 0; run < runs_of_a_case; ++run) {
    const Outing outing = random_outing(item, run);
    Driver driver(item.style, item.habits, item.limits, outing.duration_s, stream_of_run(item, run).child(2));
    runs.push_back(drive_once(item, item.robot, outing, [&](std::size_t, double now_s, const Pose& seen) {
      return driver.command_m_s(now_s, item.robot.period_s, seen);
    }));
  }
  return runs;
}

std::vector<Run> drive_innocent(const Case& item, const std::vector<Run>& driven) {
  std::vector<Run> runs;
  for (int run = 0; run < runs_of_a_case; ++run) {
    const std::vector<LogRow>& rows = driven[static_cast<std::size_t>(run)].log.rows;
    runs.push_back(drive_once(item, item.innocent, random_outing(item, run),
                              [&](std::size_t row, double, const Pose&) { return rows[row].command_m_s; }));
  }
  return runs;
}

}  // namespace plants::third
