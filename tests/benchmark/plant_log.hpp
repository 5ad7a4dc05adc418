// A drive log of any length of the published plant, with counts as an encoder gives them.
#pragma once

#include <cmath>
#include <random>

#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"
#include "tests/support/published_plant.hpp"

namespace wheelwright::benchmarks {

inline constexpr double period_s = 0.018;
inline constexpr double metres_per_tick = 0.000444565;

// Random commands that hold for 40 periods each.
inline DriveLog plant_log(double duration_s) {
  std::mt19937 random(18);
  std::uniform_real_distribution<double> any_m_s(-0.3, 0.3);
  test::PublishedPlant left;
  test::PublishedPlant right;
  DriveLog log;
  log.name = "plant";
  log.wheel_base_m = 0.235;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  const auto rows = static_cast<std::size_t>(duration_s / period_s);
  WheelPair command;
  WheelPair travelled_m;
  for (std::size_t k = 0; k < rows; ++k) {
    if (k % 40 == 0) command = {any_m_s(random), any_m_s(random)};
    DriveSample sample;
    sample.t_s = period_s * static_cast<double>(k);
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled_m.left / metres_per_tick),
                              std::llround(travelled_m.right / metres_per_tick)};
    log.samples.push_back(sample);
    travelled_m.left += period_s * left.step(command.left);
    travelled_m.right += period_s * right.step(command.right);
  }
  return log;
}

// The plant as a moving average.
inline LinearModel plant_model(std::size_t length) {
  LinearModel model;
  model.left.from_left = test::PublishedPlant::impulse_response(length);
  model.left.from_right.assign(length, 0.0);
  model.right.from_left.assign(length, 0.0);
  model.right.from_right = test::PublishedPlant::impulse_response(length);
  return model;
}

}  // namespace wheelwright::benchmarks
