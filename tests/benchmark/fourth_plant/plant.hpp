#pragma once

#include "tests/benchmark/fourth_plant/battery.hpp"
#include "tests/benchmark/fourth_plant/delay_line.hpp"
#include "tests/benchmark/fourth_plant/robot.hpp"

namespace plants::fourth {

// One run of a robot, in fine steps.
class Plant {
 public:
  Plant(const Robot& robot, const Pose& start, double battery_v, const Random& random);

  void step(const PerWheel<double>& command_m_s);

  [[nodiscard]] double time_s() const { return moment_.time_s; }
  [[nodiscard]] const Pose& pose() const { return moment_.pose; }  // of the axle, heading unwrapped
  [[nodiscard]] double battery_v() const { return moment_.battery_v; }
  [[nodiscard]] PerWheel<long> ticks() const;

 private:
  double turn_wheel(std::size_t wheel, double asked_m_s);
  double noise(std::size_t wheel, double speed_m_s);
  void roll(const PerWheel<double>& rolled_m_s);

  Robot robot_;
  Random noise_random_;
  Random block_random_;
  PerWheel<WheelDrive> drives_;
  PerWheel<DeadTime> dead_times_;
  Battery battery_;
  Moment moment_;
  PerWheel<double> noise_m_s_{};
  PerWheel<double> counted_m_{};
};

}  // namespace plants::fourth
