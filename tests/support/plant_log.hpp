// Drive logs of the published plant.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>

#include "model/log/drive_log.hpp"
#include "tests/support/published_plant.hpp"

namespace wheelwright::test {

// The speed at which a wheel acts on a command, before it lags behind.
using SpeedCurve = std::function<double(double command_m_s)>;

// A run of the published plant by random commands, counted in whole ticks of a Roomba. Saved, its first row
// stands in line 8.
inline DriveLog plant_run(unsigned seed, std::size_t rows = 1000, const SpeedCurve& curve = nullptr,
                          std::size_t rows_per_command = 9) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-0.3, 0.3);
  PublishedPlant left;
  PublishedPlant right;
  constexpr double metres_per_tick = 0.000444565;
  DriveLog log;
  log.name = "plant";
  log.wheel_base_m = 0.235;
  log.period_s = 0.018;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  log.other_metadata = {{"robot", "plant"}};
  WheelPair travelled;
  WheelPair command;
  for (std::size_t k = 0; k < rows; ++k) {
    if (k % rows_per_command == 0) command = {any(random), any(random)};
    DriveSample sample;
    sample.t_s = 0.018 * static_cast<double>(k);
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled.left / metres_per_tick),
                              std::llround(travelled.right / metres_per_tick)};
    log.samples.push_back(sample);
    travelled.left += 0.018 * left.step(curve ? curve(command.left) : command.left);
    travelled.right += 0.018 * right.step(curve ? curve(command.right) : command.right);
  }
  return log;
}

}  // namespace wheelwright::test
