#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/second_plant/robot_spec.hpp"

namespace plants::second {

// Incremental encoder on the wheel. During an outage edges pass uncounted and are gone for good.
class Encoder {
 public:
  Encoder(const EncoderSpec& spec, double duration_s, Random random) : spec_(spec) {
    const int outages = static_cast<int>(std::lround(spec.outages_per_run));
    for (int index = 0; index < outages; ++index) {
      const double from_s = random.uniform(1.0, duration_s - 2.0);
      outages_.push_back({from_s, from_s + random.uniform(spec.shortest_outage_s, spec.longest_outage_s)});
    }
  }

  long read(double now_s, double wheel_angle_rad) {
    const long edge =
        std::lround(std::floor(wheel_angle_rad * spec_.ticks_per_turn / (2.0 * std::numbers::pi)));
    if (!started_) count_ = edge;
    if (started_ && !blind(now_s)) count_ += edge - edge_;
    edge_ = edge;
    started_ = true;
    return count_;
  }

 private:
  struct Outage {
    double from_s;
    double until_s;
  };

  [[nodiscard]] bool blind(double now_s) const {
    for (const Outage& outage : outages_)
      if (now_s >= outage.from_s && now_s < outage.until_s) return true;
    return false;
  }

  EncoderSpec spec_;
  std::vector<Outage> outages_;
  long edge_ = 0;
  long count_ = 0;
  bool started_ = false;
};

}  // namespace plants::second
