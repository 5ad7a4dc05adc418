#pragma once

#include "tests/benchmark/fifth_plant/delay_line.hpp"
#include "tests/benchmark/fifth_plant/noise.hpp"
#include "tests/benchmark/plants/pose.hpp"

namespace plants::fifth {

// Cameras on the ceiling that follow a marker: late, smooth, and with noise that smoothing has left. White
// noise comes on top of it, in the row that is logged.
class Tracker {
 public:
  Tracker(const TrackerSpec& spec, const Pose& axle, const Random& random);

  void step(const Pose& axle);
  [[nodiscard]] Pose seen() const;
  // What iron near a compass makes of a heading.
  [[nodiscard]] double shown_rad(double heading_rad) const;
  // Without smoothing, latency and noise.
  [[nodiscard]] Pose marker(const Pose& axle) const;

 private:
  TrackerSpec spec_;
  DelayLine<Pose> late_;
  SlowNoise x_noise_;
  SlowNoise y_noise_;
  Pose smooth_;
  Pose noise_;
};

}  // namespace plants::fifth
