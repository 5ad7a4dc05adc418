// The hybrid pose: encoder readings filtered against the model (PAPER.md, 'Idea').
//
//   HybridFilter filter(model);                       // allocates here and never after
//   const HybridOutput out = filter.step(frame);      // once for each SensorFrame, in order
//
// The command of a frame is in force from its tick on, and its counts were read right after it was sent; so
// the pose that step() returns is that at the beginning of the frame's tick, as PoseRecord::odometry is.
// Frames may be invalid (sensors not heard) and ticks may be left out: the model then stands in, and for
// ticks left out the last command is taken to have stayed in force.
//
// Limits. The encoders do not see the floor: two wheels that slip alike, or a robot that is carried, look
// like driving. Where the wheel-speed controller of the robot holds the speed, another floor shows in the
// motor currents and hardly in the counts. While the robot is not armed nobody knows its commands; encoders
// are then believed as they are.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "model/filter/fault.hpp"
#include "model/filter/filter_noise.hpp"
#include "model/filter/pose_with_covariance.hpp"
#include "model/filter/wheel_filter.hpp"
#include "model/linear_model.hpp"
#include "model/robot_model.hpp"
#include "model/sensor_frame.hpp"

namespace wheelwright {

// What one tick says of a wheel.
struct HybridWheel {
  double speed_m_s = 0.0;     // of the model, corrected by the travel that the encoder showed
  double innovation_m = 0.0;  // encoder minus prediction, in metres of travel
  double innovation = 0.0;    // the same in standard deviations
  bool accepted = false;      // the reading was used
  bool discarded = false;     // it came, and the model stood in for it
};

struct HybridOutput {
  std::int64_t tick = 0;
  Pose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x, y, theta in the frame of the pose
  HybridWheel left;
  HybridWheel right;
  FaultEvents events;
};

class HybridFilter {
 public:
  // Throws std::invalid_argument where the model lacks the encoder scale.
  explicit HybridFilter(const RobotModel& model);
  HybridFilter(const LinearModel& model, const WheelPair& metres_per_tick, const FilterNoise& noise);

  HybridOutput step(const SensorFrame& frame);

  // The robot is at a known pose. What is known of model, encoders and faults stays.
  void set_pose(const Pose& pose) { pose_.reset(pose); }
  const Pose& pose() const { return pose_.pose(); }

 private:
  struct Side {
    WheelFilter filter;
    double metres_per_tick;
    double gain_standard_error;
  };

  void advance_model(const SensorFrame& frame);
  HybridWheel step_wheel(Side& side, const SensorFrame& frame, double predicted_m, std::int64_t ticks,
                         double& step_m, double& variance_m2) const;

  double period_s_;
  FilterNoise noise_;
  LinearPredictor predictor_;
  Side left_;
  Side right_;
  PoseWithCovariance pose_;
  bool started_ = false;
  std::int64_t tick_ = 0;
  WheelPair command_;
  WheelPair predicted_m_;  // over the last tick
};

}  // namespace wheelwright
