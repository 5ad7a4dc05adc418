#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/brain/brain.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/allocation/route_plan.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// A robot whose gain fades as it drives: where it is depends on how long it has driven.
RobotModel fading_robot() {
  RobotModel model = test::lagging_robot();
  model.effects.push_back({{"gain_drift", "", {-0.1, 20.0}}, {}, {}, {}, {}, {}});
  return model;
}

// The brain alone, its commands given as they come; from the stop on the robot is told to stand, whatever
// was made before.
class StoppedDrive {
 public:
  explicit StoppedDrive(const RobotModel& model)
      : brain_(test::triangle_mission(PoseSource::fir), RobotLimits{},
               std::make_unique<DrivingModel>(model)) {}

  void drive(std::int64_t ticks, std::optional<std::int64_t> stop_at) {
    for (std::int64_t tick = 0; tick < ticks; ++tick) {
      SensorFrame frame;
      frame.tick = tick;
      frame.armed = true;
      frame.valid = true;
      const bool stopped = stop_at && tick >= *stop_at;
      if (stopped) frame.stop = StopReason::bump;
      const Command& made = made_.at(static_cast<std::size_t>(tick) % made_.size());
      if (made.tick == tick) frame.command = made;
      if (stopped) frame.command.speed_m_s = {};
      records.push_back(brain_.take(frame));
      while (const auto command = brain_.next_command())
        made_.at(static_cast<std::size_t>(command->tick) % made_.size()) = *command;
    }
  }

  std::vector<PoseRecord> records;

 private:
  Brain brain_;
  std::array<Command, 64> made_{};
};

// The model's own motion from the beginning of the route by the commands that are on record.
Pose simulated(const RobotModel& model, const std::vector<PoseRecord>& records) {
  ModelSimulation simulation(model);
  for (std::size_t i = 0; i + 1 < records.size(); ++i) {
    if (records[i].command.activity != Activity::route && records[i].stop == StopReason::none) {
      simulation.reset({});
      continue;
    }
    simulation.step(records[i].command.speed_m_s);
  }
  return simulation.pose();
}

}  // namespace

TEST_CASE("After a stop on the route the model's pose is that by the commands which were given") {
  const RobotModel model = fading_robot();
  for (const std::int64_t stop_at : {200, 217, 231, 300}) {
    INFO("stopped at tick " << stop_at);
    StoppedDrive drive(model);
    drive.drive(stop_at + 60, stop_at);
    const Pose expected = simulated(model, drive.records);
    const Pose& last = drive.records.back().predicted;
    CHECK(drive.records.back().has_prediction);
    CHECK_THAT(last.x_m, WithinAbs(expected.x_m, 1e-9));
    CHECK_THAT(last.y_m, WithinAbs(expected.y_m, 1e-9));
    CHECK_THAT(last.theta_rad, WithinAbs(expected.theta_rad, 1e-9));

    // The commands that had been made would have taken the robot further.
    StoppedDrive on(model);
    on.drive(stop_at + 60, std::nullopt);
    const Pose& driven_on = on.records.back().predicted;
    CHECK(distance_between_m(driven_on, last) + std::abs(driven_on.theta_rad - last.theta_rad) > 0.05);
  }
}
