// What is known of a route before it is driven from the model alone.
#include "model/brain/route_forecast.hpp"

#include <algorithm>
#include <string>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

RobotModel model_with_gain_error(double standard_error) {
  RobotModel model;
  LinearModel& linear = model.linear_part;
  linear.left.from_left = linear.right.from_right = {0.0, 0.0, 0.3, 0.4, 0.2, 0.1};
  linear.left.from_right = linear.right.from_left = std::vector<double>(6, 0.0);
  WheelFit fit;
  fit.gain_standard_error = {standard_error, 0.0};
  model.left_fit = fit;
  fit.gain_standard_error = {0.0, standard_error};
  model.right_fit = fit;
  model.encoder_scale = EncoderScale{{0.000444565, 0.000444565}, 1660.0, 0.001};
  return model;
}

Route square() {
  return {"square", 0.2, 0.02, {{1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}};
}

Mission mission_within(double largest_m, PoseSource source = PoseSource::fir) {
  Mission mission;
  mission.route = square();
  mission.pose_source = source;
  mission.largest_uncertainty_m = largest_m;
  return mission;
}

}  // namespace

TEST_CASE("A forecast reaches all checkpoints in order, each where the route has it") {
  const RouteForecast forecast = forecast_route(model_with_gain_error(0.002), square(), RobotLimits{});
  REQUIRE(forecast.finished);
  REQUIRE(forecast.checkpoints.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Checkpoint wanted = square().checkpoints[i];
    CHECK(std::hypot(forecast.checkpoints[i].pose.x_m - wanted.x_m,
                     forecast.checkpoints[i].pose.y_m - wanted.y_m) < 0.06);
    if (i > 0) CHECK(forecast.checkpoints[i].t_s > forecast.checkpoints[i - 1].t_s);
  }
}

TEST_CASE("A model whose gains are less sure may end further off") {
  const auto radius_m = [](double standard_error) {
    return forecast_route(model_with_gain_error(standard_error), square(), RobotLimits{})
        .checkpoints.back()
        .radius95_m;
  };
  CHECK(radius_m(0.02) > 2.0 * radius_m(0.002));
}

TEST_CASE("A route that the model cannot hold is doubted at the first checkpoint beyond the limit") {
  const RobotModel model = model_with_gain_error(0.01);
  const auto forecast = forecast_route(model, square(), RobotLimits{});
  const double limit_m = 0.5 * (forecast.checkpoints[1].radius95_m + forecast.checkpoints[0].radius95_m);
  const auto doubt = doubt_of_route(model, mission_within(limit_m), RobotLimits{});
  REQUIRE(doubt);
  CHECK_THAT(doubt->reason, ContainsSubstring("route 'square'") &&
                                ContainsSubstring("at checkpoint 2 of 4") &&
                                ContainsSubstring("between checkpoints 1 and 2"));
}

TEST_CASE("Sensors that steer, a wide limit and no limit raise no doubt of a route") {
  const RobotModel model = model_with_gain_error(0.01);
  CHECK_FALSE(doubt_of_route(model, mission_within(0.01, PoseSource::hybrid), RobotLimits{}));
  CHECK_FALSE(doubt_of_route(model, mission_within(0.01, PoseSource::odometry), RobotLimits{}));
  CHECK_FALSE(doubt_of_route(model, mission_within(10.0), RobotLimits{}));
  Mission mission = mission_within(1.0);
  mission.largest_uncertainty_m.reset();
  CHECK_FALSE(doubt_of_route(model, mission, RobotLimits{}));
}
