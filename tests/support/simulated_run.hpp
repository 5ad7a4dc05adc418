// Short cuts to the simulated robot for tests.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "config/load/simulation_config.hpp"
#include "drivers/open_interface/commands.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "model/simulation/motion_predictor.hpp"

namespace wheelwright::test {

inline simulation::SimulationConfig robot_in_room(const std::string& robot, const std::string& room,
                                                  std::uint64_t seed) {
  const auto folder = std::filesystem::path(WHEELWRIGHT_SOURCE_DIR) / "config/robots";
  auto config = config::load_simulation_config(folder / (robot + ".yaml"));
  config.room = config::load_room(folder / "rooms" / (room + ".yaml"));
  config.seed = seed;
  return config;
}

struct DriveErrors {
  double command_rms_m_s = 0.0;
  double speed_error_rms_m_s = 0.0;  // of both wheels' mean speed over a period, against the truth
};

// Drives a robot that stands with random commands that hold for ten periods each, beside a model that is at
// rest.
inline DriveErrors drive_randomly(simulation::SimulatedRobot& robot, MotionPredictor& predictor, int periods,
                                  unsigned seed) {
  using namespace std::chrono_literals;
  open_interface::CommandBytes bytes;
  bytes.start();
  bytes.safe_mode();
  robot.receive(bytes.bytes());
  robot.advance(200ms);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> speed_mm_s(-300, 300);
  int left = 0;
  int right = 0;
  DriveErrors sums;
  for (int k = 0; k < periods; ++k) {
    if (k % 10 == 0) {
      left = speed_mm_s(random);
      right = speed_mm_s(random);
    }
    bytes.clear();
    bytes.drive_direct(right, left);
    robot.receive(bytes.bytes());
    // The mean over the period, by the trapezoidal rule over its milliseconds.
    WheelPair mean;
    constexpr int steps = 18;
    for (int step = 0; step < steps; ++step) {
      const auto before = robot.truth();
      robot.advance(1ms);
      const auto after = robot.truth();
      mean.left += 0.5 * (before.speed_left_m_s + after.speed_left_m_s) / steps;
      mean.right += 0.5 * (before.speed_right_m_s + after.speed_right_m_s) / steps;
    }
    const WheelPair command{1e-3 * left, 1e-3 * right};
    const WheelPair predicted = predictor.step(command);
    sums.command_rms_m_s += command.left * command.left + command.right * command.right;
    sums.speed_error_rms_m_s +=
        std::pow(predicted.left - mean.left, 2) + std::pow(predicted.right - mean.right, 2);
  }
  return {std::sqrt(sums.command_rms_m_s / (2 * periods)),
          std::sqrt(sums.speed_error_rms_m_s / (2 * periods))};
}

}  // namespace wheelwright::test
