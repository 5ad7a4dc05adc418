// The robot's own period from the times at which its frames arrived, and how uneven they came.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wheelwright::tools::doctor {

// Quantiles of a set of durations.
struct Spread {
  double p50_s = 0.0;
  double p99_s = 0.0;
  double largest_s = 0.0;
};

Spread spread_of(std::vector<double> durations_s);

struct FrameArrival {
  std::int64_t number = 0;  // counted by the robot: frames that were lost on the way count too
  double time_s = 0.0;
};

struct PeriodFit {
  double period_s = 0.0;
  double uncertainty_s = 0.0;  // half width of a 95 % interval
  Spread jitter;               // distance of the arrivals from the even beat
};

// Fits time against number, so that what USB does to single frames averages out. Nothing where there are
// fewer than ten frames.
std::optional<PeriodFit> fit_period(std::span<const FrameArrival> arrivals);

}  // namespace wheelwright::tools::doctor
