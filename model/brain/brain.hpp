// The brain of the robot: a pure step function from sensor frames to commands.
//
// take() receives the frame of a tick; next_command() then gives commands, in tick order, as many as may be
// given: one at a time if the manoeuvre needs the sensors, several ticks ahead if the model alone steers the
// route. No clock, no I/O; the same frames give the same commands. take() and next_command() do not allocate.
//
// If the model knows the encoder scale, the hybrid filter runs with every pose source, so that faults are
// found and logged in each run. The filter steers only with the source `hybrid`. With the sources `fir` and
// `arma` the caller has to give a model of that type: the brain drives by the model that it is given.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/brain/driving_model.hpp"
#include "model/brain/manoeuvre.hpp"
#include "model/brain/mission.hpp"
#include "model/brain/random_drive.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/route/route_follower.hpp"
#include "model/simulation/odometry.hpp"

namespace wheelwright {

// One tick as the brain saw it, for the pose log.
struct PoseRecord {
  std::int64_t tick = 0;  // since the start of the run
  double t_s = 0.0;
  Command command;
  StopReason stop = StopReason::none;
  bool has_prediction = false;
  Pose predicted;  // by the model, from commands alone
  WheelPair predicted_speed_m_s;
  // Covariance of x, y, theta of `predicted`, in the frame of that pose (model/uncertainty); zero if the
  // model states no uncertainty.
  Eigen::Matrix3d predicted_covariance = Eigen::Matrix3d::Zero();
  Pose odometry;
  WheelPair measured_speed_m_s;
  // Where the model knows the encoder scale; at the instant of `odometry`.
  std::optional<HybridOutput> hybrid;
  std::uint16_t visited = 0;        // checkpoints
  std::uint16_t model_version = 1;  // of the model that was driven by (Brain::exchange_model)
  bool valid = false;               // the sensors of this tick were received
};

class Brain {
 public:
  // `model` may be empty where the mission calibrates first.
  Brain(const Mission& mission, const RobotLimits& limits, std::unique_ptr<DrivingModel> model);

  // Receives a frame and returns what to log of it. A run starts whenever the robot becomes armed; before
  // that it is told to stand.
  PoseRecord take(const SensorFrame& frame);

  // The next command, or nothing where the next frame has to come first.
  std::optional<Command> next_command();

  // What the calibrator found. It takes effect when the brain stops waiting for it. How long the machine took
  // to find it does not show in the run.
  void accept_encoder_order() { outcome_arrived_ = true; }
  void accept_encoder_scale(const WheelPair& metres_per_tick);
  void accept_model(std::unique_ptr<DrivingModel> model);
  // A better model of the same robot, made while the robot drives. It replaces the present model between two
  // ticks, at the frame of `from_tick` or the next frame after that. It starts with the motion that the
  // commands of the last 9 s give it, at the pose of the replaced model. From then on the records have
  // `version`.
  void exchange_model(std::unique_ptr<DrivingModel> model, std::int64_t from_tick, std::uint16_t version);
  // The replaced model, for the caller to free outside the real-time thread; null most of the time.
  std::unique_ptr<DrivingModel> take_retired_model() { return std::move(retired_model_); }
  // A calibration was refused: the run ends.
  void refuse();

  Activity activity() const { return activity_; }
  bool ended() const { return activity_ == Activity::finished || activity_ == Activity::stopped; }
  // Why the wheels have to stop now, which whoever sends the commands has to see to: a wheel is held and does
  // not come free, or odometry, with an encoder that counts no more, would turn on the spot for ever.
  StopReason wanted_stop() const;
  // Why the run ended early.
  StopReason stop_reason() const { return stop_; }
  const PoseRecord& last_record() const { return last_record_; }

 private:
  // What is done one after the other.
  enum class Stage : std::uint8_t { manoeuvre, await, random_drive, route, coast, commanded_drive };
  struct Prediction {
    std::int64_t tick = -1;
    Pose pose;
    WheelPair speed_m_s;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    std::uint16_t visited = 0;
  };

  struct PastCommand {
    std::int64_t tick = -1;
    WheelPair speed_m_s;
  };
  struct Exchange {
    std::unique_ptr<DrivingModel> model;
    std::int64_t from_tick = 0;
    std::uint16_t version = 1;
  };

  // The manoeuvre of a stage, what the robot is told is going on, and what has to come in before it ends.
  struct Step {
    Stage stage;
    std::unique_ptr<Manoeuvre> manoeuvre;
    Activity activity;
  };

  void plan_steps();
  void begin_run(std::int64_t tick);
  void advance();
  void enter_step();
  void stand_at(const Pose& pose);
  bool is_sensorless_stage() const;
  void apply_accepted();
  void apply_exchange(std::int64_t tick);
  void end_by(StopReason reason);
  WheelOrder order();
  std::optional<WheelOrder> stage_order();
  std::optional<WheelOrder> await_order(Activity activity);
  std::optional<WheelOrder> random_order();
  std::optional<WheelOrder> route_order();
  std::optional<WheelOrder> coast_order();
  Pose steering_rest_pose();
  Pose rest_by_sensors(const Pose& measured);
  bool in_run(const SensorFrame& frame) const;
  int ticks_ahead() const;
  void watch_faults(const PoseRecord& record);
  void take_back_commands(const SensorFrame& frame, bool stops);
  void remember_prediction(std::int64_t tick, std::uint16_t visited);
  Stage stage() const;

  Mission mission_;
  RobotLimits limits_;
  std::unique_ptr<DrivingModel> model_;
  std::unique_ptr<DrivingModel> accepted_model_;
  std::unique_ptr<DrivingModel> retired_model_;
  std::optional<WheelPair> accepted_scale_;
  Exchange exchange_;
  std::uint16_t model_version_ = 1;
  Odometry odometry_;
  RandomDrive random_drive_;
  RouteFollower follower_;
  std::vector<Step> steps_;
  std::size_t step_ = 0;
  bool was_armed_ = false;
  bool running_ = false;
  StopReason stop_ = StopReason::none;
  bool outcome_arrived_ = false;
  int ticks_without_count_ = 0;  // on a route by odometry
  int ticks_held_ = 0;
  int ticks_in_stage_ = 0;
  Activity activity_ = Activity::idle;

  SensorFrame latest_;
  std::int64_t next_tick_ = 0;
  std::int64_t start_tick_ = 0;
  WheelPair measured_speed_;
  std::array<Prediction, 64> predictions_{};      // by tick, as far ahead as commands are made
  std::array<PastCommand, 512> past_commands_{};  // by tick, those in advance included
  std::int64_t rest_tick_ = 0;                    // the model was at rest then
  PoseRecord last_record_;
};

}  // namespace wheelwright
