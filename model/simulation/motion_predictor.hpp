// The model at the wheel: commands in, pose out, one period at a time; and where the robot would come to
// rest.
#pragma once

#include <optional>

#include "model/geometry/pose.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"
#include "model/simulation/steady_state_map.hpp"

namespace wheelwright {

// Allocates when it is made and never after.
class MotionPredictor {
 public:
  explicit MotionPredictor(const LinearModel& model);
  // With the effects of the model: the predictor plans through them.
  explicit MotionPredictor(const RobotModel& model);

  // Moves on by one period with this command in force. Returns the mean wheel speeds over the period.
  WheelPair step(const WheelPair& command);

  // Motion since the last reset, from commands alone.
  const Pose& pose() const { return simulation_.pose(); }
  // What the last period brought.
  const ModelSimulation::Motion& motion() const { return simulation_.motion(); }
  const WheelPair& speed_m_s() const { return simulation_.motion().wheel_m_s; }

  // The pose at which the robot comes to rest if it is told to stop now. While it drives ahead, its heading
  // is the one with which it would go on straight, where that is another
  // (DriveLimits::straightening_periods).
  Pose rest_pose();

  // The commands that hold these wheel speeds once settled.
  WheelPair command_for(const WheelPair& speed_m_s) const;

  // Without effects there are none.
  DriveLimits limits() const { return settled_ ? settled_->limits() : DriveLimits{}; }

  // Sets the pose, not the motion.
  void set_pose(const Pose& pose) { simulation_.set_pose(pose); }
  // To rest at a pose.
  void reset(const Pose& pose);
  // The model in motion, and to go on from where it was at another time.
  const ModelSimulation& simulation() const { return simulation_; }
  void go_on_from(const ModelSimulation& then) { simulation_ = then; }
  // Goes on from the pose of another predictor of the same robot; the motion is its own.
  void take_over(const MotionPredictor& before) { simulation_.take_over(before.simulation_); }

  double period_s() const { return period_s_; }
  double wheel_base_m() const { return wheel_base_m_; }

 private:
  double straightened_heading_rad(const Pose& rest);
  MotionPredictor(const LinearModel& linear_part, std::span<const EffectSetting> effects);

  double period_s_;
  double wheel_base_m_;
  DcGain left_gain_;
  DcGain right_gain_;
  std::optional<SteadyStateMap> settled_;  // where there are effects
  ModelSimulation simulation_;
  ModelSimulation scratch_;
};

}  // namespace wheelwright
