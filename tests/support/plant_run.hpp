// Drive logs of the published plant on both wheels.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "model/log/drive_log.hpp"
#include "tests/support/published_plant.hpp"

namespace wheelwright::test {

inline constexpr double create2_tick_m = 0.000444565;

struct PlantRunPlan {
  std::size_t rows = 1000;
  double metres_per_tick = 1e-13;  // fine enough for speeds to be exact to 1e-11 m/s
  unsigned seed = 1;
  std::size_t hold = 1;  // periods for which each random command holds
};

// Normally distributed random commands (calibration C of the source paper), 0.2 m/s standard deviation.
inline DriveLog plant_run(const PlantRunPlan& plan) {
  std::mt19937 random(plan.seed);
  std::normal_distribution<double> normal(0.0, 0.2);
  PublishedPlant left;
  PublishedPlant right;
  DriveLog log;
  log.name = "plant";
  log.wheel_base_m = 0.235;
  log.period_s = 0.018;
  log.metres_per_tick = WheelPair{plan.metres_per_tick, plan.metres_per_tick};
  WheelPair travelled;
  WheelPair command;
  for (std::size_t k = 0; k < plan.rows; ++k) {
    if (k % plan.hold == 0) command = {normal(random), normal(random)};
    DriveSample sample;
    sample.t_s = 0.018 * static_cast<double>(k);
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled.left / plan.metres_per_tick),
                              std::llround(travelled.right / plan.metres_per_tick)};
    log.samples.push_back(sample);
    travelled.left += 0.018 * left.step(command.left);
    travelled.right += 0.018 * right.step(command.right);
  }
  return log;
}

}  // namespace wheelwright::test
