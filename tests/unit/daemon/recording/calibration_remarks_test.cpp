#include "daemon/recording/calibration_remarks.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::daemon;

namespace {

RobotModel wheels_of(double left, double right, double error) {
  RobotModel model;
  model.left_fit = WheelFit{{left, 0.0}, {error, 0.0}};
  model.right_fit = WheelFit{{0.0, right}, {0.0, error}};
  return model;
}

}  // namespace

TEST_CASE("A count that is a tenth shorter than expected points to the wheel base") {
  config::DaemonConfig config;
  config.limits.wheel_base_m = 0.21;
  EncoderScaleFit fit;
  const double nominal_m = config.limits.metres_per_tick.left;
  fit.metres_per_tick = {0.9 * nominal_m, 0.9 * nominal_m};
  const auto remark = remark_on_scale(fit, config);
  REQUIRE(remark);
  CHECK_THAT(*remark, ContainsSubstring("a count is 10.0 % shorter than robot.nominal_metres_per_tick"));
  CHECK_THAT(*remark, ContainsSubstring("robot.wheel_base_m, 0.21 m"));
  fit.metres_per_tick = {0.97 * nominal_m, 0.97 * nominal_m};
  CHECK_FALSE(remark_on_scale(fit, config));
}

TEST_CASE("Wheels that differ surely and by much are pointed to, by the wheel that goes less far") {
  const auto remark = remark_on_wheels(wheels_of(0.95, 1.0, 0.003));
  REQUIRE(remark);
  CHECK_THAT(*remark, ContainsSubstring("the left wheel goes 5.0 % less far per command"));
  CHECK_THAT(remark_on_wheels(wheels_of(1.05, 0.95, 0.003)).value_or(""),
             ContainsSubstring("the right wheel"));
  CHECK_FALSE(remark_on_wheels(wheels_of(0.97, 1.0, 0.003)));
  CHECK_FALSE(remark_on_wheels(wheels_of(0.95, 1.0, 0.02)));
  CHECK_FALSE(remark_on_wheels(RobotModel{}));
}
