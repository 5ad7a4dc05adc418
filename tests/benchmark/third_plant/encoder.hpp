#pragma once

#include <cmath>
#include <optional>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/third_plant/episodes.hpp"

namespace plants::third {

struct EncoderSpec {
  double metres_per_tick = 4.0e-4;
  EpisodeSpec dropouts;
  bool delivers_afterwards = false;  // what a dropout kept back; else it is lost
};

// Counter of one wheel, which begins anywhere.
class Encoder {
 public:
  Encoder(const EncoderSpec& spec, Random random)
      : spec_(spec), start_ticks_(random.uniform(1500.0, 90000.0)) {}

  long read(double travel_m, bool dropped_out) {
    const long passed = std::lround(std::floor(start_ticks_ + travel_m / spec_.metres_per_tick)) - lost_;
    if (dropped_out) {
      if (!frozen_) frozen_ = passed;
      return *frozen_;
    }
    if (!frozen_) return passed;
    const long kept_back = passed - *frozen_;
    frozen_.reset();
    if (spec_.delivers_afterwards) return passed;
    lost_ += kept_back;
    return passed - kept_back;
  }

 private:
  EncoderSpec spec_;
  double start_ticks_;
  long lost_ = 0;
  std::optional<long> frozen_;
};

}  // namespace plants::third
