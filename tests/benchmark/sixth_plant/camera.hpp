#pragma once

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// A mast with the marker on top, which sways as the body under it is accelerated.
class Mast {
 public:
  explicit Mast(const Hidden& hidden);

  void step(double forward_m_s, double turn_rad_s);
  [[nodiscard]] double x_m() const { return x_m_; }
  [[nodiscard]] double y_m() const { return y_m_; }

 private:
  void sway(double& place_m, double& speed_m_s, double pushed_m_s2) const;

  double natural_rad_s_;
  double before_m_s_ = 0.0;
  double x_m_ = 0.0;
  double y_m_ = 0.0;
  double x_m_s_ = 0.0;
  double y_m_s_ = 0.0;
};

// The camera overhead, and the marker that it sees.
class Camera {
 public:
  Camera(const Robot& robot, const Hidden& hidden) : noise_(robot.noise), hidden_(hidden), mast_(hidden) {}

  void step(double forward_m_s, double turn_rad_s);
  Pose look(const Pose& axle, Random& measuring);

 private:
  NoiseSpecs noise_;
  const Hidden& hidden_;
  Mast mast_;
  Pose slow_;
};

}  // namespace plants::sixth
