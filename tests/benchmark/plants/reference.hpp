#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/sensors.hpp"

namespace plants {

// The outside reference: noise on every axis, heading within one turn; always on the first and the last row.
class Reference {
 public:
  Reference(const SensorSet& sensors, double period_s, std::size_t rows, Random random)
      : sensors_(sensors),
        random_(random),
        every_(std::max(1L, std::lround(sensors.pose_every_s / period_s))),
        last_row_(static_cast<long>(rows) - 1) {}

  std::optional<Pose> look(long row, const Pose& truth) {
    const Pose seen{truth.x_m + random_.normal(sensors_.position_noise_m),
                    truth.y_m + random_.normal(sensors_.position_noise_m),
                    wrapped_rad(truth.heading_rad + random_.normal(sensors_.heading_noise_rad))};
    const bool at_end = row == 0 || row == last_row_;
    const bool due = !sensors_.only_end_poses && row % every_ == 0;
    if (at_end || due) return seen;
    return std::nullopt;
  }

 private:
  SensorSet sensors_;
  Random random_;
  long every_;
  long last_row_;
};

}  // namespace plants
