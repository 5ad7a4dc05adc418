#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/benchmark/fourth_plant/block.hpp"

namespace plants::fourth {

// What was put in some steps ago; before the first, what the line was filled with.
template <class Value>
class DelayLine {
 public:
  DelayLine(std::size_t steps, const Value& filling) : values_(steps + 1, filling) {}

  Value step(const Value& input) {
    values_[next_] = input;
    next_ = (next_ + 1) % values_.size();
    return oldest();
  }

  [[nodiscard]] const Value& oldest() const { return values_[next_]; }

  // What came in that many steps before the newest.
  [[nodiscard]] Value back(std::size_t steps) const {
    return values_[(next_ + values_.size() - 1 - steps) % values_.size()];
  }

 private:
  std::vector<Value> values_;
  std::size_t next_ = 0;
};

inline std::size_t steps_in(double time_s, double step_s) {
  return static_cast<std::size_t>(std::lround(time_s / step_s));
}

// A dead time as a block.
class DeadTime {
 public:
  DeadTime(double time_s, double step_s) : line_(steps_in(time_s, step_s), 0.0) {}
  double operator()(double input, const Moment& /*moment*/) { return line_.step(input); }

 private:
  DelayLine<double> line_;
};

}  // namespace plants::fourth
