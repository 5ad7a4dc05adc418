// The body on the floor: how the wheels' travel becomes motion, and what the floor, the tyres and the caster
// do.
#pragma once

#include <cstdint>
#include <random>

#include "tests/support/gap_plant/plant_parameters.hpp"

namespace wheelwright::test {

class FloorContact {
 public:
  FloorContact(const PlantParameters& robot, const Pose& start, double dt_s, std::uint64_t seed);

  // Moves the body by the wheels' travel over a step; `hardest_m_s2` is the larger acceleration of the two
  // rims.
  void step(const WheelPair& travel_m, double hardest_m_s2);

  // What hampers the body now, as a force on each motor; zero where the tyres give way instead.
  WheelPair load_m_s() const;

  const Pose& pose() const { return pose_; }  // of the middle of the axle
  const Twist& twist() const { return twist_; }

 private:
  Twist upset();  // what is added to the body's motion
  double caster_turn_rad_s();
  bool on_patch() const;
  double grip_noise(double& state, double travel_m);

  const PlantParameters robot_;
  double dt_s_;
  Pose pose_;
  Twist twist_;
  Twist upset_;    // now
  Twist slipped_;  // as the tyres give way, with a lag
  WheelPair grip_;
  double caster_rad_ = 0.0;  // between the caster and where it will trail
  double caster_side_ = 1.0;
  double direction_ = 0.0;  // of the last travel
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace wheelwright::test
