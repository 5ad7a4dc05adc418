#pragma once

#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// Counters on the shafts of the wheels, which go by the size of the wheels that the log says.
class Counters {
 public:
  Counters(const Robot& robot, const Hidden& hidden, double duration_s, Random& chance, Random& measuring);

  void step(double time_s, const PerWheel<double>& rim_m_s);
  [[nodiscard]] const PerWheel<double>& counted_m() const { return counted_m_; }
  [[nodiscard]] PerWheel<long> ticks(const PerWheel<double>& counted_m) const;

 private:
  struct Gap {
    double from_s;
    double to_s;
    bool left_only;
  };
  [[nodiscard]] bool dead(std::size_t side, double time_s) const;

  double metres_per_tick_;
  std::vector<Gap> gaps_;
  PerWheel<double> first_ticks_;  // a counter starts anywhere within a tick
  PerWheel<double> counted_m_{};
};

}  // namespace plants::sixth
