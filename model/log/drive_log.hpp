// What was commanded and what was measured during one run of a robot: a drive log in memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/log/delay_kernel.hpp"

namespace wheelwright {

// Encoder counts of the two wheels, unwrapped.
struct WheelTicks {
  std::int64_t left = 0;
  std::int64_t right = 0;
};

// One row. What was not measured at that moment is absent.
struct DriveSample {
  double t_s = 0.0;       // since the start of the run
  WheelPair command_m_s;  // commanded wheel speeds, in force from this row on
  std::optional<WheelTicks> ticks;
  std::optional<double> reference_x_m;  // pose from an outside reference, in its own frame
  std::optional<double> reference_y_m;
  std::optional<double> reference_theta_rad;
  std::optional<double> gyro_z_rad_s;  // raw
  std::optional<double> battery_v;
  bool counter_reset = false;  // of the travel since the counts before, these do not tell all

  // Where x, y and heading were measured.
  std::optional<Pose> reference_pose() const {
    if (!reference_x_m || !reference_y_m || !reference_theta_rad) return std::nullopt;
    return Pose{*reference_x_m, *reference_y_m, *reference_theta_rad};
  }
};

// A column that the format does not name.
struct ExtraColumn {
  std::string name;
  std::vector<double> values;      // one per sample; not-a-number where the field was empty or no number
  std::vector<std::string> texts;  // one per sample as it stands in the file; empty where all are numbers
};

// Metadata of a log whose metres per tick no one states: "commands" or "reference", by which they were found.
inline constexpr std::string_view scale_from_key = "scale_from";

// Standard deviations of one reference pose.
struct PoseNoise {
  double position_m = 1e-3;  // of a good tracker
  double heading_rad = 2e-3;
};

struct DriveLog {
  std::string name;  // of the file, for messages
  double wheel_base_m = 0.0;
  double period_s = 0.0;                     // nominal time between samples
  std::optional<WheelPair> metres_per_tick;  // present where there are ticks
  WheelPair initial_travel_m;                // tells the angle at which the wheels stood at the start
  double references_late_s = 0.0;            // behind the counts, where that has been found
  ReferenceResponse reference_response;      // likewise, where a delay alone does not describe it
  std::optional<PoseNoise> reference_noise;  // where it is known
  bool reference_scaled_by_counts = false;   // how far a count goes cannot be judged by it
  std::vector<std::pair<std::string, std::string>> other_metadata;
  std::vector<DriveSample> samples;  // times strictly rising
  std::vector<ExtraColumn> extra_columns;
  std::size_t first_line = 1;  // line of the first sample in its file, for messages

  bool has_ticks() const { return metres_per_tick && !samples.empty() && samples.front().ticks; }
  // Else references have headings alone, or there are none.
  bool has_reference_positions() const {
    return std::ranges::any_of(samples,
                               [](const DriveSample& sample) { return sample.reference_pose().has_value(); });
  }
};

}  // namespace wheelwright
