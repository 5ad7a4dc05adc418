// How far the pose of a drive from the model alone may be off: the covariance of x, y and heading.
//
// Errors of parameters are the same in every period. What one of them does to the pose is
// d_k, half of the difference between two simulations of the same commands, with that parameter moved up and
// down by one standard deviation (moved_models.hpp), so that the nonlinearity of effects counts:
//
//   P = sum_k d_k d_k' + N
//
// N is carried along the linearised motion (filter/pose_with_covariance.hpp). It has the random walk of the
// wheels' travel against the model, slip that grows with the way, the moment at which the robot takes up a
// command, anywhere within its refresh period, and the mismatch of the wheels (FilterNoise::wheel_mismatch).
//
// P is in the frame of the pose. It says nothing of what no parameter of the model stands for: another
// floor, a push, an effect that was not found.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/filter/filter_noise.hpp"
#include "model/filter/pose_with_covariance.hpp"
#include "model/geometry/pose.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Allocates when it is made and never after.
class PoseUncertainty {
 public:
  explicit PoseUncertainty(const RobotModel& model);

  // Moves on by one period with this command in force. `motion` is that of the model itself over the period.
  void step(const WheelPair& command_m_s, const ModelSimulation::Motion& motion);

  // The robot is known to rest at this pose.
  void reset(const Pose& pose);
  // The robot is known to be at this pose: what noise has added so far is dropped; its motion stays.
  void set_pose(const Pose& pose);
  // Goes on in the place of another model of the same robot, from `pose`: what was uncertain stays so.
  void take_over(const PoseUncertainty& before, const Pose& pose);

  Eigen::Matrix3d covariance() const;

 private:
  TravelVariance noise_of(const WheelPair& command_m_s, const WheelPair& floor_m_s) const;

  double period_s_;
  FilterNoise noise_;
  struct Moved {
    ModelSimulation up;
    ModelSimulation down;
  };
  std::vector<Moved> moved_;
  PoseWithCovariance with_noise_;  // the pose of the model itself
  WheelPair command_m_s_;          // of the period before
};

// 95 % point of chi squared with two degrees of freedom: -2 ln 0.05.
inline constexpr double chi_square95_of_two = 5.991464547107979;

// The 95 % ellipse of a position: in 95 of 100 drives the robot is within it.
struct PositionEllipse {
  double major_m = 0.0;  // half axes
  double minor_m = 0.0;
  double direction_rad = 0.0;  // of the major axis
};
PositionEllipse position_ellipse95(const Eigen::Matrix3d& covariance);

// The ellipse around `pose`, as that many corners and the first one again.
std::vector<Pose> ellipse95_outline(const Pose& pose, const Eigen::Matrix3d& covariance, int corners);

// The radius around the pose within which the robot is in 95 of 100 drives, to 0.2 %: a cubic in the ratio of
// the two deviations (R. W. Leenhouts, "On the computation of bi-normal radial error", Navigation 32 (1985)
// 16-28).
double position_radius95_m(const Eigen::Matrix3d& covariance);

// Whether two estimates of where a robot is exclude each other: they are further apart than twice what both
// radii together allow. Of a sound pair fewer than one in 10 000 does.
bool exclude_each_other(const Pose& one, const Eigen::Matrix3d& covariance_of_one, const Pose& other,
                        const Eigen::Matrix3d& covariance_of_other);

}  // namespace wheelwright
