#include "model/brain/route_forecast.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "model/brain/driving_model.hpp"
#include "model/route/route_follower.hpp"

namespace wheelwright {
namespace {

constexpr double longest_route_s = 3600.0;

// Where the radius grows most: from one checkpoint (0: the start) to the next.
std::size_t largest_growth(const std::vector<RouteForecast::Checkpoint>& checkpoints, std::size_t end) {
  std::size_t largest = 0;
  double growth_m = -1.0;
  for (std::size_t i = 0; i <= end; ++i) {
    const double before_m = i == 0 ? 0.0 : checkpoints[i - 1].radius95_m;
    if (checkpoints[i].radius95_m - before_m <= growth_m) continue;
    growth_m = checkpoints[i].radius95_m - before_m;
    largest = i;
  }
  return largest;
}

std::string describe(const RouteForecast& forecast, std::size_t beyond, const Mission& mission) {
  const std::size_t steepest = largest_growth(forecast.checkpoints, beyond);
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "route '" << mission.route->name
       << "' cannot be held by the model alone: at checkpoint " << beyond + 1 << " of "
       << mission.route->checkpoints.size() << " the robot may be " << forecast.checkpoints[beyond].radius95_m
       << " m off (95 % of drives are within it), and run.largest_uncertainty_m is "
       << *mission.largest_uncertainty_m << "; most of it comes ";
  if (steepest == 0) {
    text << "before checkpoint 1";
  } else {
    text << "between checkpoints " << steepest << " and " << steepest + 1;
  }
  text << ", where a look at the sensors would help most; set run.pose_source to hybrid, shorten the route, "
          "or allow "
          "more";
  return text.str();
}

}  // namespace

RouteForecast forecast_route(const RobotModel& model, const Route& route, const RobotLimits& limits) {
  DrivingModel driving(model);
  RouteFollower follower(route, follower_limits(limits));
  driving.rest_at({});
  RouteForecast forecast;
  for (double t_s = 0.0; t_s < longest_route_s && !follower.finished(); t_s += limits.period_s) {
    const WheelPair speed = follower.steer(driving.predictor.rest_pose(), driving.predictor.limits());
    const Pose& pose = driving.predictor.pose();
    while (forecast.checkpoints.size() < follower.visited()) {
      forecast.checkpoints.push_back({t_s, pose, position_radius95_m(driving.uncertainty->covariance())});
    }
    if (follower.finished()) break;
    driving.step(rounded_command(driving.predictor.command_for(speed), limits));
  }
  forecast.finished = follower.finished();
  return forecast;
}

std::optional<Refusal> doubt_of_route(const RobotModel& model, const Mission& mission,
                                      const RobotLimits& limits) {
  if (!mission.route || !mission.largest_uncertainty_m || !is_sensorless(mission.pose_source))
    return std::nullopt;
  const RouteForecast forecast = forecast_route(model, *mission.route, limits);
  const auto beyond =
      std::find_if(forecast.checkpoints.begin(), forecast.checkpoints.end(),
                   [&](const auto& at) { return at.radius95_m > *mission.largest_uncertainty_m; });
  if (beyond != forecast.checkpoints.end()) {
    return Refusal{
        describe(forecast, static_cast<std::size_t>(beyond - forecast.checkpoints.begin()), mission)};
  }
  if (forecast.finished) return std::nullopt;
  return Refusal{"route '" + mission.route->name +
                 "' is not driven to its end within an hour by the model alone"};
}

}  // namespace wheelwright
