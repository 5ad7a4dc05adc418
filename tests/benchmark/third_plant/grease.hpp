#pragma once

#include <cmath>

namespace plants::third {

// Grease that is cold at the start of a run and thins as the drive is used.
struct GreaseSpec {
  double cold_drag_n_s_m = 0.0;
  double warming_s = 40.0;
};

class Grease {
 public:
  explicit Grease(const GreaseSpec& spec) : spec_(spec) {}

  // `use` is the sum of both wheels' speeds over the largest command.
  void step(double use, double step_s) { warmth_ += step_s * (0.7 + 0.3 * use - warmth_) / spec_.warming_s; }

  [[nodiscard]] double drag_n(double speed_m_s) const {
    constexpr double thinning = 1.6;
    return spec_.cold_drag_n_s_m * std::exp(-thinning * warmth_) * speed_m_s;
  }

 private:
  GreaseSpec spec_;
  double warmth_ = 0.0;  // 1 = warm
};

}  // namespace plants::third
