// Mean and spread of a quantity while all is as usual, learnt late so that a change is seen before it is
// taken for usual.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace wheelwright {

class UsualLevel {
 public:
  bool ready() const { return learnt_ >= min_learnt; }
  double mean() const { return mean_; }
  double spread() const { return std::sqrt(variance_); }

  void take(double value) {
    if (count_ == delay) {
      learn(waiting_[next_]);
    } else {
      ++count_;
    }
    waiting_[next_] = value;
    next_ = (next_ + 1) % delay;
  }
  // What was not learnt yet, never will be.
  void forget_recent() { count_ = 0; }

 private:
  static constexpr std::size_t delay = 24;
  static constexpr int min_learnt = 24;
  static constexpr double slowest_rate = 0.002;

  void learn(double value) {
    ++learnt_;
    const double rate = std::max(slowest_rate, 1.0 / learnt_);
    const double difference = value - mean_;
    mean_ += rate * difference;
    variance_ = (1.0 - rate) * (variance_ + rate * difference * difference);
  }

  double mean_ = 0.0;
  double variance_ = 0.0;
  int learnt_ = 0;
  std::array<double, delay> waiting_{};  // ring
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace wheelwright
