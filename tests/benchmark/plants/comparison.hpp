#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/plants/sensors.hpp"

namespace plants {

// How far a case lies from the same robot without what is hidden, on the same drives.
struct Comparison {
  double wheel_speed_m_s = 0.0;    // RMS over windows of 0.25 s
  double wheel_bent_m_s = 0.0;     // what a linear model of the commands cannot take up of it
  double wheel_noise_m_s = 0.0;    // from the tick quantiser
  double lateral_speed_m_s = 0.0;  // of the reference point
  double forward_speed_m_s = 0.0;  // of the reference point
  double forward_bent_m_s = 0.0;
  double forward_noise_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  double turn_bent_rad_s = 0.0;
  double turn_noise_rad_s = 0.0;
};

// Commands of both wheels in so many rows, evenly back from one row over the memory.
std::vector<double> past_commands(const Run& run, std::size_t row, std::size_t memory_rows, std::size_t lags);

Comparison compare(const std::vector<Run>& hidden, const std::vector<Run>& innocent,
                   const SensorSet& sensors);

std::string comparison_header();
std::string comparison_line(const std::string& case_name, const Comparison& comparison);

}  // namespace plants
