// References as filters of trackers show them. Rows of a log are taken to be evenly spaced.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright::test {

using Filter = std::function<std::vector<double>(const std::vector<double>& values, double period_s)>;

// An exponential mean of the past.
inline Filter low_pass(double time_constant_s) {
  return [=](const std::vector<double>& values, double period_s) {
    std::vector<double> shown{values.front()};
    const double share = 1.0 - std::exp(-period_s / time_constant_s);
    for (std::size_t i = 1; i < values.size(); ++i)
      shown.push_back(shown.back() + share * (values[i] - shown.back()));
    return shown;
  };
}

// The mean of the last so many seconds.
inline Filter moving_mean(double window_s) {
  return [=](const std::vector<double>& values, double period_s) {
    const auto count = static_cast<std::size_t>(std::lround(window_s / period_s));
    std::vector<double> shown;
    for (std::size_t i = 0; i < values.size(); ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < count; ++j) sum += values[i >= j ? i - j : 0];
      shown.push_back(sum / static_cast<double>(count));
    }
    return shown;
  };
}

// One low-pass forward in time and one backward: no delay.
inline Filter both_ways(double time_constant_s) {
  return [=](const std::vector<double>& values, double period_s) {
    const Filter once = low_pass(time_constant_s);
    const std::vector<double> forward = once(values, period_s);
    const std::vector<double> back = once({forward.rbegin(), forward.rend()}, period_s);
    return std::vector<double>(back.rbegin(), back.rend());
  };
}

inline Filter delayed(double delay_s) {
  return [=](const std::vector<double>& values, double period_s) {
    const auto rows = static_cast<std::size_t>(std::lround(delay_s / period_s));
    std::vector<double> shown;
    for (std::size_t i = 0; i < values.size(); ++i) shown.push_back(values[i >= rows ? i - rows : 0]);
    return shown;
  };
}

// Filters the references of a run that has one in each row.
inline void filter_reference(DriveLog& run, const Filter& position, const Filter& heading) {
  const auto filtered = [&](std::optional<double> DriveSample::*part, const Filter& filter, bool unwrap) {
    if (!filter) return;
    std::vector<double> values;
    for (const DriveSample& sample : run.samples) {
      const double value = *(sample.*part);
      values.push_back(unwrap && !values.empty() ? values.back() + wrap_angle(value - values.back()) : value);
    }
    values = filter(values, run.period_s);
    for (std::size_t i = 0; i < values.size(); ++i) run.samples[i].*part = values[i];
  };
  filtered(&DriveSample::reference_x_m, position, false);
  filtered(&DriveSample::reference_y_m, position, false);
  filtered(&DriveSample::reference_theta_rad, heading, true);
}

}  // namespace wheelwright::test
