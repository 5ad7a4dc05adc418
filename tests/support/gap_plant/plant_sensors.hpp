// What the robot of the gap benchmark measures of itself, and what is measured of it from outside.
#pragma once

#include <cstdint>
#include <random>

#include "model/log/drive_log.hpp"
#include "tests/support/gap_plant/plant_parameters.hpp"

namespace wheelwright::test {

class PlantSensors {
 public:
  PlantSensors(const PlantParameters& robot, double period_s, bool wrap_heading, std::uint64_t seed);

  // Once per row; `rim_m` is the travel of the wheels, `battery_v` the true voltage.
  void measure(DriveSample& sample, const WheelPair& rim_m, const Pose& pose, const Twist& twist,
               double battery_v);

 private:
  struct Encoder {
    std::int64_t offset = 0;
    std::int64_t last = 0;
    int lost_rows = 0;  // still to come
  };

  std::int64_t count(Encoder& encoder, double rim_m);
  double noise(double deviation) { return deviation * normal_(random_); }

  const PlantParameters robot_;
  double period_s_;
  bool wrap_heading_;
  Encoder left_;
  Encoder right_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace wheelwright::test
