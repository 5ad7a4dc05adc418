#pragma once

#include <vector>

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"

namespace plants::sixth {

// What the sensors look at.
struct Measurable {
  PerWheel<double> counted_m{};
  Pose axle;
};

// Measurements that are the older the longer ago the clock was set, which it is every nine seconds.
class LateStamps {
 public:
  LateStamps(const Hidden& hidden, Random& chance);

  // To be called once in a millisecond.
  void remember(const Measurable& now);
  [[nodiscard]] Measurable seen_at(double time_s, const Measurable& now) const;

 private:
  double most_s_;
  double phase_s_;
  std::vector<Measurable> past_;  // by milliseconds
};

}  // namespace plants::sixth
