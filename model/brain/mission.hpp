// What a run is to do, and with what figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "model/brain/commanded_drive.hpp"
#include "model/calibration/encoder_scale_fit.hpp"
#include "model/geometry/pose.hpp"
#include "model/geometry/sensor_period.hpp"
#include "model/route/route.hpp"
#include "model/route/route_follower.hpp"

namespace wheelwright {

// Turning in place for the encoder scale (calibration A of the source paper).
struct EncoderTurnPlan {
  double speed_m_s = 0.1;  // of each wheel
  // Counter-clockwise, and then as many clockwise; at the ticks per turn that are expected.
  double turns_each_way = 2.0;
  EncoderScaleOptions options;
};

// The four response actions (calibration B of the source paper).
struct ResponsePlan {
  double speed_m_s = 0.15;
  double speed_spread = 0.3;  // relative, over the repetitions: ticks and speed steps then round differently
  // Long enough that what a wheel loses to friction as it starts is small beside its way, and that a slow
  // speed controller has settled.
  double on_s = 2.5;  // at `speed_m_s`; slower actions are longer, so that all roll the same way
  int repetitions = 6;
  bool alternate_direction =
      true;              // each repetition undoes the one before, so that the robot stays where it is
  bool use_fall = true;  // false with the wheel PID off, where stopping is slower than starting
};

// The random drive (calibration C of the source paper), and a tour at the end of it;
// model/brain/random_drive.hpp.
struct RandomDrivePlan {
  double duration_s = 60.0;  // of both
  double spread_m_s = 0.1;   // standard deviation of the wheel speeds
  // Short holds show the dynamics, long ones, in which a wheel settles, the gain.
  double shortest_hold_s = 0.1;
  double longest_hold_s = 1.2;
  double largest_change_m_s = 0.15;  // of one wheel at once; harder steps make a Roomba report overcurrent
  // The circle in which the middle of the axle stays, and how far its middle is ahead of where the run began:
  // turning in place needs an object near by (behind the robot), the circle needs free floor.
  double radius_m = 0.5;
  double ahead_m = 0.6;
  // The tour: this share of the time the robot drives between random points of the circle as it drives a
  // route.
  double tour_share = 0.8;
  double tour_speed_m_s = 0.2;  // that of the route, where one is driven
  std::uint64_t seed = 1;
  std::optional<std::size_t> order = 9;  // of the model; found by a sweep where absent
};

// Where the pose that the route is steered by comes from.
enum class PoseSource : std::uint8_t {
  fir,       // a model of type fir and the commands alone; no sensor is read
  arma,      // the same by a model of type arma
  hybrid,    // encoders filtered against the model, of either type (model/filter/hybrid_filter.hpp)
  odometry,  // encoders as they are
};
std::string_view name_of(PoseSource source);

// Commands do not depend on any sensor, and may be made in advance.
constexpr bool is_sensorless(PoseSource source) {
  return source == PoseSource::fir || source == PoseSource::arma;
}

struct Mission {
  std::optional<EncoderTurnPlan> encoder_turn;
  std::optional<ResponsePlan> response;
  std::optional<RandomDrivePlan> random_drive;
  std::optional<Route> route;
  std::optional<CommandedDrive> commanded_drive;
  PoseSource pose_source = PoseSource::fir;
  // Keep the model up to date while a route is driven (model/adaptation/continuous_calibration.hpp).
  bool adapt = false;
  // A route by the model alone is refused where a checkpoint may be missed by more
  // (model/brain/route_forecast.hpp).
  std::optional<double> largest_uncertainty_m;
};

// The robot and the limits within which it may be moved.
struct RobotLimits {
  double period_s = default_period_s;
  double wheel_base_m = 0.235;
  WheelPair metres_per_tick{0.000444565, 0.000444565};  // until a calibration says better
  double largest_wheel_speed_m_s = 0.3;
  double slowest_wheel_speed_m_s = 0.04;
  double acceleration_m_s2 = 0.4;
  double command_step_m_s = 0.001;  // commands are rounded to it: what the robot can be told
  int ticks_ahead = 8;              // for which commands are made in advance where no sensor is needed
};

// As the follower of a route takes them.
FollowerLimits follower_limits(const RobotLimits& limits);

// As the robot can be told it: within the largest speed, in whole command steps.
WheelPair rounded_command(const WheelPair& command_m_s, const RobotLimits& limits);

}  // namespace wheelwright
