#pragma once

#include "tests/benchmark/fifth_plant/robot.hpp"
#include "tests/benchmark/plants/random.hpp"

namespace plants::fifth {

// Quadrature counters on the shafts of the wheels.
class Encoders {
 public:
  Encoders(const EncoderSpec& spec, double radius_m, const Random& random);

  void step(const PerWheel<double>& shaft_rad_s);
  [[nodiscard]] PerWheel<long> ticks() const;

 private:
  [[nodiscard]] bool connected();

  EncoderSpec spec_;
  double radius_m_;
  Random random_;
  double time_s_ = 0.0;
  double loose_from_s_ = no_limit;
  std::size_t loose_wheel_ = left_side;
  PerWheel<double> counted_m_{};
};

}  // namespace plants::fifth
