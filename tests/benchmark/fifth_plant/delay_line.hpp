#pragma once

#include <cmath>
#include <vector>

#include "tests/benchmark/fifth_plant/robot.hpp"

namespace plants::fifth {

template <class Value>
class DelayLine {
 public:
  DelayLine(double delay_s, const Value& first)
      : held_(static_cast<std::size_t>(std::lround(delay_s / fine_step_s)) + 1, first) {}

  Value step(const Value& newest) {
    held_[next_] = newest;
    next_ = (next_ + 1) % held_.size();
    return held_[next_];
  }

 private:
  std::vector<Value> held_;
  std::size_t next_ = 0;
};

}  // namespace plants::fifth
