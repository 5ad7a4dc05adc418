#pragma once

#include "tests/benchmark/plants/pose.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/sixth_plant/castor.hpp"

namespace plants::sixth {

// The body on its floor.
class Body {
 public:
  Body(const Robot& robot, const Hidden& hidden, const Pose& start, Random& chance);

  [[nodiscard]] double ground_m_s(std::size_t side) const;
  // Drag on a wheel by where it is and what lies on it.
  [[nodiscard]] double more_drag_n_s_m(std::size_t side) const;
  // The floor shakes what is seen of the motion and not the motion.
  void step(double time_s, const PerWheel<double>& push_n, double rims_m_s, double shaken_m_s,
            double shaken_rad_s);

  [[nodiscard]] double track_m() const { return track_m_; }
  [[nodiscard]] double forward_m_s() const { return forward_m_s_; }
  [[nodiscard]] double turn_rad_s() const { return turn_rad_s_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }

 private:
  [[nodiscard]] double forward_n(double time_s) const;
  double yaw_n_m(double rims_m_s);
  [[nodiscard]] bool on_patch(std::size_t side) const;

  const Robot& robot_;
  const Hidden& hidden_;
  Castor castor_;
  double track_m_;
  double floor_yield_n_s_m_;
  double fan_phase_rad_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  Pose pose_;
  double load_side_ = 0.0;  // 1 = right, -1 = left, 0 = middle
};

}  // namespace plants::sixth
