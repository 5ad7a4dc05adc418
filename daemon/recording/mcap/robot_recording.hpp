// A run of a robot as MCAP messages: which topics there are, and what is in them.
//
// | topic | schema | on |
// |---|---|---|
// | /pose/model, /pose/odometry, /pose/hybrid | foxglove.PoseInFrame, in the frame `route` | each tick |
// | /pose/reference | foxglove.PoseInFrame, in the frame `reference` | where it was measured |
// | /tf | foxglove.FrameTransform, `route` to `base_link`, by the pose that steers | each tick |
// | /wheels | wheelwright.Wheels | each tick |
// | /sensors | wheelwright.Sensors | each tick on which the robot was received |
// | /hybrid/covariance, /model/covariance | wheelwright.Covariance, of the pose of that name | each tick |
// | /state | wheelwright.State | each change |
// | /log | foxglove.Log | changes of activity, stops, events of the fault detector |
//
// What was not measured is absent. Times are those of the run: nanoseconds since its start.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "daemon/recording/mcap/json_object.hpp"
#include "daemon/recording/mcap/writer.hpp"
#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::mcap {

struct SensorValues {
  std::optional<double> battery_v;
  std::optional<double> gyro_z_rad_s;
  std::optional<WheelPair> motor_current_a;
  std::optional<std::array<double, 6>> light_bumper;  // from left to right, 0 to 4095
  bool bump = false;
  bool wheel_drop = false;
  bool cliff = false;
  int overcurrents = 0;

  bool empty() const { return !battery_v && !gyro_z_rad_s && !motor_current_a && !light_bumper; }
};

struct StateValues {
  std::string activity;
  std::string stop;  // why the wheels were put to rest; "none" or empty where they were not
  int checkpoints_visited = 0;
  int model_version = 1;
  std::string discarded;  // wheel whose reading the filter did not use: left, right, both
  std::string fault_left;
  std::string fault_right;
  bool recalibration_due = false;

  bool operator==(const StateValues&) const = default;
};

// All that is known of one tick.
struct TickValues {
  double t_s = 0.0;
  std::optional<WheelPair> command_m_s;
  std::optional<WheelPair> predicted_m_s;
  std::optional<WheelPair> measured_m_s;
  std::optional<WheelTicks> ticks;
  std::optional<Pose> model;
  std::optional<Pose> odometry;
  std::optional<Pose> hybrid;
  std::optional<Pose> reference;
  // xx, xy, yy, x theta, y theta, theta theta: of hybrid, and of model.
  std::optional<std::array<double, 6>> covariance;
  std::optional<std::array<double, 6>> model_covariance;
  std::optional<SensorValues> sensors;
  std::optional<StateValues> state;
  std::string events;  // of the fault detector, as in the pose log
};

// Which of the poses steers.
enum class SteeringPose : std::uint8_t { model, odometry, hybrid };
// Of a pose source: fir, arma, odometry or hybrid; any other name is taken for the model's.
SteeringPose steering_pose(std::string_view pose_source);

class RobotRecording {
 public:
  RobotRecording(Sink sink, const std::map<std::string, std::string>& metadata, SteeringPose steering,
                 const WriterOptions& options = {});

  // Ticks in the order of time; those before the start of the run are left out.
  void add(const TickValues& tick);
  // See Writer.
  void end_chunk() { writer_.end_chunk(); }
  bool finish() { return writer_.finish(); }
  std::uint64_t lost_messages() const { return writer_.lost_messages(); }

 private:
  struct Topics {
    std::uint16_t model, odometry, hybrid, reference, transform, wheels, sensors, covariance,
        model_covariance, state, log;
  };
  static Topics add_topics(Writer& writer);

  void add_pose(std::uint16_t channel, std::string_view frame, const std::optional<Pose>& pose);
  void add_transform(const TickValues& tick);
  void add_wheels(const TickValues& tick);
  void add_sensors(const SensorValues& sensors);
  void add_covariance(std::uint16_t channel, const std::optional<std::array<double, 6>>& covariance);
  void add_state(const StateValues& state);
  void say(int level, std::string_view message);

  Writer writer_;
  Topics topics_;
  SteeringPose steering_;
  JsonObject json_;
  std::uint64_t time_ns_ = 0;
  std::optional<StateValues> last_state_;
};

}  // namespace wheelwright::mcap
