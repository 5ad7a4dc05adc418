// Drives of a simulated robot with random commands, kept frame by frame beside the truth: what the hybrid
// filter is judged on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "daemon/replay/virtual_run.hpp"
#include "model/simulation/robot_model.hpp"
#include "tests/support/simulated_run.hpp"
#include "tests/unit/drivers/roomba/linked_robot.hpp"

namespace wheelwright::test {

struct RecordedDrive {
  std::vector<SensorFrame> frames;  // from the first tick of the drive on
  std::vector<Pose> true_poses;     // one per frame, as seen from where the drive began
};

// A robot that has calibrated itself: encoder scale and FIR model.
inline RobotModel calibrated_model(const std::string& robot_name, const std::string& room,
                                   std::uint64_t seed) {
  simulation::SimulatedRobot robot(robot_in_room(robot_name, room, seed));
  daemon::VirtualRunConfig config;
  config.mission.encoder_turn = EncoderTurnPlan{};
  config.mission.response = ResponsePlan{};
  const auto result = daemon::run_virtually(config, robot);
  if (!result.finished) {
    throw std::runtime_error("calibration refused: " +
                             (result.refusal ? result.refusal->reason : std::string(name_of(result.stop))));
  }
  return *result.model;
}

// The robot on an endless floor with the grip of linoleum.
inline simulation::SimulationConfig robot_on_endless_floor(const std::string& robot_name,
                                                           std::uint64_t seed) {
  auto config = robot_in_room(robot_name, "empty", seed);
  config.room.floor.grip = 0.7;
  config.room.floor.creep_per_n = 0.001;
  return config;
}

// Random segments as routes have them: straights, arcs, turns in place, some backwards, some stands. Speeds
// change at the route follower's acceleration, in one segment of five in a step.
class RandomSegments {
 public:
  explicit RandomSegments(std::uint64_t seed) : random_(static_cast<std::mt19937::result_type>(seed)) {}

  WheelPair next() {
    if (left_in_segment_-- <= 0) draw();
    const double most = step_ ? 1.0 : 0.4 * 0.018;
    now_.left += std::clamp(goal_.left - now_.left, -most, most);
    now_.right += std::clamp(goal_.right - now_.right, -most, most);
    const auto millimetres = [](double speed) { return 1e-3 * std::round(1e3 * speed); };
    return {millimetres(now_.left), millimetres(now_.right)};
  }

 private:
  void draw() {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    left_in_segment_ = static_cast<int>((0.6 + 2.4 * uniform(random_)) / 0.018);
    const bool abrupt = uniform(random_) < 0.2;
    const double kind = uniform(random_);
    const double speed = 0.08 + 0.17 * uniform(random_);
    const double turn = 2.0 * uniform(random_) - 1.0;
    if (kind < 0.45) {
      goal_ = {speed, speed};
    } else if (kind < 0.70) {
      goal_ = {speed * (1.0 - 0.5 * turn), speed * (1.0 + 0.5 * turn)};
    } else if (kind < 0.85) {
      const double spin = std::copysign(0.6 * speed, turn);
      goal_ = {-spin, spin};
    } else if (kind < 0.93) {
      goal_ = {-0.7 * speed, -0.7 * speed};
    } else {
      goal_ = {};
    }
    goal_.left = std::clamp(goal_.left, -0.3, 0.3);
    goal_.right = std::clamp(goal_.right, -0.3, 0.3);
    // A harder step would trip the overcurrent stop.
    const double change = std::max(std::abs(goal_.left - now_.left), std::abs(goal_.right - now_.right));
    step_ = abrupt && change < 0.2;
  }

  std::mt19937 random_;
  WheelPair goal_;
  WheelPair now_;
  int left_in_segment_ = 0;
  bool step_ = false;
};

// Called each tick before time moves on, from 0 at the start of the drive: a place to inject faults.
using DriveHook = std::function<void(simulation::SimulatedRobot&, int tick)>;

inline RecordedDrive record_drive(const simulation::SimulationConfig& robot_config, std::uint64_t route_seed,
                                  double duration_s, const DriveHook& hook = {}) {
  roomba::LinkedRobot linked(roomba::LinkConfig{}, robot_config);
  linked.start();
  linked.drive_for(20, 0.0, 0.0);
  RandomSegments segments(route_seed);
  RecordedDrive drive;
  const auto ticks = static_cast<int>(duration_s / 0.018);
  const int rest_from = ticks - 60;
  const Pose start = linked.robot.truth().pose;
  for (int tick = 0; tick < ticks; ++tick) {
    if (hook) hook(linked.robot, tick);
    const WheelPair command = tick < rest_from ? segments.next() : WheelPair{};
    drive.frames.push_back(linked.drive(command.left, command.right));
    drive.true_poses.push_back(between(start, linked.robot.truth().pose));
  }
  return drive;
}

}  // namespace wheelwright::test
