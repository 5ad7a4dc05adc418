#pragma once

#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::third {

// Short troubles of one wheel or the other, spread over a run.
struct EpisodeSpec {
  int per_run = 0;
  double shortest_s = 0.1;
  double longest_s = 0.3;
};

class Episodes {
 public:
  Episodes(const EpisodeSpec& spec, double run_s, Random random) {
    constexpr double margin_s = 2.0;
    for (int index = 0; index < spec.per_run; ++index) {
      const double share = (index + random.uniform(0.05, 0.95)) / spec.per_run;
      const double from_s = margin_s + (run_s - 2.0 * margin_s) * share;
      const double until_s = from_s + random.uniform(spec.shortest_s, spec.longest_s);
      episodes_.push_back({from_s, until_s, random.chance(0.5) ? left_side : right_side});
    }
  }

  [[nodiscard]] bool hit(std::size_t wheel, double now_s) const {
    for (const Episode& episode : episodes_)
      if (episode.wheel == wheel && now_s > episode.from_s && now_s < episode.until_s) return true;
    return false;
  }

 private:
  struct Episode {
    double from_s;
    double until_s;
    std::size_t wheel;
  };

  std::vector<Episode> episodes_;
};

}  // namespace plants::third
