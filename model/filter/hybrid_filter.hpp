// The hybrid pose: encoder readings filtered against the model (an idea of the source paper).
//
//   HybridFilter filter(model);                       // allocates here and never after
//   const HybridOutput out = filter.step(frame);      // once for each SensorFrame, in order
//
// The command of a frame is in force from its tick on, and its counts were read right after it was sent; so
// the pose that step() returns is that at the beginning of the frame's tick, as PoseRecord::odometry is.
// Frames may be invalid (sensors not received) and ticks may be left out: the model then stands in, and for
// ticks left out the last command is taken to have stayed in force.
//
// The prediction is the free run of the whole model, effects included: what the wheels do is compared with
// the counts, and what the body does beyond its wheels' travel (slip, geometry, slope) is added to the pose.
// Effects that act by place, heading or the angle of a wheel act where the filter has the robot.
//
// Where a model with effects is in doubt (model_doubt.hpp) the gates widen, and the encoders weigh more.
//
// Limits. The encoders do not see the floor: two wheels that slip alike, or a robot that is carried, look
// like driving. Where the wheel-speed controller of the robot holds the speed, another floor shows in the
// motor currents and hardly in the counts; a floor with less grip that pulls no harder shows in neither. A
// push sideways turns no wheel. The wheel-drop switches are one bit here: a wheel hangs, not which. A jump of
// less than about half a centimetre passes for noise. While the robot is not armed nobody knows its commands;
// encoders are then believed as they are.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "model/filter/environment_monitor.hpp"
#include "model/filter/fault.hpp"
#include "model/filter/fault_detector.hpp"
#include "model/filter/filter_noise.hpp"
#include "model/filter/gain_misfit.hpp"
#include "model/filter/model_doubt.hpp"
#include "model/filter/pose_with_covariance.hpp"
#include "model/filter/scale_drift_detector.hpp"
#include "model/filter/wheel_filter.hpp"
#include "model/geometry/wheel_side.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"

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
  Pose pose;                                             // of the middle of the axle
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x, y, theta in the frame of the pose
  HybridWheel left;
  HybridWheel right;
  FaultKind left_fault = FaultKind::none;  // that lasts
  FaultKind right_fault = FaultKind::none;
  FaultEvents events;                 // of this tick, to be logged
  bool recalibration_due = false;     // stays until the filter is made again or recalibrated() is called
  bool raised_recalibration = false;  // on this tick
};

class HybridFilter {
 public:
  // Throws std::invalid_argument where the model lacks the encoder scale.
  explicit HybridFilter(const RobotModel& model);
  HybridFilter(const LinearModel& model, const WheelPair& metres_per_tick, const FilterNoise& noise,
               std::span<const EffectSetting> effects = {});

  HybridOutput step(const SensorFrame& frame);

  // The robot is at a known pose. What is known of model, encoders and faults stays.
  void set_pose(const Pose& pose) { pose_.reset(pose); }
  const Pose& pose() const { return pose_.pose(); }
  // Before the first frame: a command that was in force for one period, so that the model is in motion then
  // as the robot is.
  void prime(const WheelPair& command_m_s);
  // Before the first frame: goes on in the place of a filter by another model of the same robot. The pose,
  // how well it is known, and which counter is the left one stay; everything else is learnt again.
  void take_over(const HybridFilter& before) {
    pose_ = before.pose_;
    exchanged_ = before.exchanged_;
  }
  // The environment is taken for usual as it is from now on. After a new model make a new filter instead.
  void recalibrated() {
    environment_.recalibrated();
    misfit_.restart();
    model_is_off_ = false;
  }
  const EnvironmentMonitor& environment() const { return environment_; }
  // The model in motion, where the filter has the robot.
  const ModelSimulation& simulation() const { return simulation_; }

 private:
  struct Side {
    Side(const WheelNoise& noise, double period_s, double scale, double gain_standard_error)
        : filter(noise, period_s), drift(period_s, gain_standard_error), metres_per_tick(scale) {}

    WheelFilter filter;
    ScaleDriftDetector drift;
    double metres_per_tick;
    double predicted_m = 0.0;  // over this tick
    double doubt_m = 0.0;      // by which that may be another (model_doubt.hpp)
    double speed_m_s = 0.0;    // of the model
    double acceleration_m_s2 = 0.0;
    double counted_m = 0.0;  // total of the last reading that was received
    double predicted_since_received_m = 0.0;
    bool was_received = false;
    bool counts_backwards = false;
    std::int64_t turned_tick = 0;  // when it last stood or was to turn round
    bool stalled = false;
    bool distrusted = false;
    double taken_out_m = 0.0;  // by a verdict, still to be put into the pose
    HybridWheel out;
    WheelEvidence evidence;
    double step_m = 0.0;
    double variance_m2 = 0.0;
  };

  void advance_model(const SensorFrame& frame);
  void set_prediction(Side& side, double predicted_m, double ticks) const;
  static void watch_turn(Side& side, double command_m_s, std::int64_t tick);
  void step_wheel(Side& side, const SensorFrame& frame, std::int64_t ticks);
  void gather(Side& side, const WheelReading& reading, const WheelEstimate& estimate);
  void judge(const SensorFrame& frame, HybridOutput& output);
  void obey(Side& side, bool stalled, bool distrusted, double take_out_m);
  static bool is_in_doubt(const Side& side);
  bool watch_gain(const SensorFrame& frame);
  bool watch_environment(const SensorFrame& frame, bool both_misfit);

  double period_s_;
  FilterNoise noise_;
  double wheel_base_m_;
  ModelSimulation simulation_;
  ModelDoubt doubt_;
  WheelPair rolled_m_;   // since the start, as filtered
  Twist beyond_wheels_;  // way and turn of the body over this tick, beyond the wheels' travel
  Side left_;
  Side right_;
  FaultDetector detector_;
  EnvironmentMonitor environment_;
  GainMisfit misfit_;
  PoseWithCovariance pose_;
  bool started_ = false;
  bool model_is_off_ = false;
  bool received_ = false;
  std::int64_t last_received_tick_ = 0;
  bool exchanged_ = false;  // left and right counts
  std::int64_t tick_ = 0;
  std::int64_t last_not_driven_tick_ = 0;
  WheelPair command_;
};

}  // namespace wheelwright
