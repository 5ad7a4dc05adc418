// What the tests for faults of a wheel and its encoder are given each tick.
#pragma once

namespace wheelwright {

// No wheel makes such a step between two readings, beyond what their ages can differ by.
inline constexpr double min_jump_m = 0.003;

struct WheelEvidence {
  double predicted_m = 0.0;  // travel of the model since the last reading that was received
  double counted_m = 0.0;    // and of the encoder
  double metres_per_tick = 0.0;
  double innovation_m = 0.0;
  double reading_sd_m = 0.0;  // of one reading of travel
  bool received = false;      // there is a reading, and one before it to compare with
  bool new_origin = false;    // the link has given the counts a new origin
  bool accepted = false;
  bool suspended = false;  // the model stands in
  bool resynchronised = false;
  double kept_out_m = 0.0;
  double excess_a = 0.0;  // motor current beyond what the motion needs, smoothed
};

}  // namespace wheelwright
