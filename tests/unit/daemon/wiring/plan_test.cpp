// What the daemon refuses to start with, and in what words.
#include "daemon/wiring/plan.hpp"

#include <string>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

RobotModel model_of(ModelType type) {
  RobotModel model;
  model.linear_part.type = type;
  model.encoder_scale = EncoderScale{{0.000444565, 0.000444565}, 1660.0, 0.001};
  return model;
}

std::string refusal(PoseSource source, std::optional<RobotModel> model) {
  config::DaemonConfig config;
  config.pose_source = source;
  try {
    daemon::make_plan(config, std::move(model));
  } catch (const config::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A model of another type than the pose source is refused with both names and what to do") {
  CHECK_THAT(refusal(PoseSource::arma, model_of(ModelType::fir)),
             ContainsSubstring("model.yaml: holds a model of type fir, but run.pose_source is 'arma'"));
  CHECK_THAT(refusal(PoseSource::fir, model_of(ModelType::arma)), ContainsSubstring("set it to 'arma'"));
  for (const auto type : {ModelType::fir, ModelType::arma}) {
    for (const auto source : {PoseSource::hybrid, PoseSource::odometry}) {
      CHECK(refusal(source, model_of(type)).empty());
    }
  }
  CHECK(refusal(PoseSource::arma, model_of(ModelType::arma)).empty());
  CHECK(refusal(PoseSource::fir, model_of(ModelType::fir)).empty());
}

TEST_CASE("A source that no calibration of this configuration can serve is refused before it begins") {
  CHECK_THAT(refusal(PoseSource::arma, std::nullopt),
             ContainsSubstring("calibration.type makes a model of type fir"));
}

TEST_CASE("The hybrid source is refused where the model has no encoder scale") {
  RobotModel model = model_of(ModelType::fir);
  model.encoder_scale.reset();
  CHECK_THAT(refusal(PoseSource::hybrid, model), ContainsSubstring("encoder_scale"));
  CHECK(refusal(PoseSource::fir, model).empty());
}

TEST_CASE("A route that the model cannot hold within the limit is refused before the robot is armed") {
  config::DaemonConfig config;
  config.route = Route{"far", 0.2, 0.02, {{5.0, 0.0}}};
  config.largest_uncertainty_m = 0.02;
  RobotModel model = model_of(ModelType::fir);
  model.linear_part.left.from_left = model.linear_part.right.from_right = {0.0, 0.5, 0.5};
  model.linear_part.left.from_right = model.linear_part.right.from_left = {0.0, 0.0, 0.0};
  CHECK_THROWS_WITH(
      daemon::make_plan(config, model),
      ContainsSubstring("model.yaml: route 'far' cannot be held by the model alone: at checkpoint 1"));
  config.largest_uncertainty_m = 2.0;
  CHECK_NOTHROW(daemon::make_plan(config, model));
}

TEST_CASE("Given commands need no model and calibrate only where that is always done") {
  config::DaemonConfig config;
  config.commanded_drive = CommandedDrive{"x", {{0.0, {0.1, 0.1}}}, 1.0};
  for (const auto when :
       {config::CalibrateWhen::never, config::CalibrateWhen::if_needed, config::CalibrateWhen::always}) {
    config.calibrate = when;
    const auto plan = daemon::make_plan(config, std::nullopt);
    CHECK(plan.mission.commanded_drive);
    CHECK(plan.mission.encoder_turn.has_value() == (when == config::CalibrateWhen::always));
  }
  config.calibrate = config::CalibrateWhen::never;
  config.pose_source = PoseSource::arma;
  CHECK(daemon::make_plan(config, model_of(ModelType::fir)).model);
}

TEST_CASE("A model that was made with another wheel base is refused with both") {
  RobotModel model = model_of(ModelType::fir);
  model.linear_part.wheel_base_m = 0.3;
  CHECK_THAT(refusal(PoseSource::fir, model),
             ContainsSubstring("was made with a wheel base of 0.3 m, but robot.wheel_base_m is 0.235 m"));
}

TEST_CASE("A port that cannot carry the sensors of a period within it is refused") {
  config::DaemonConfig config;
  config.pose_source = PoseSource::odometry;
  config.baud = 19200;
  CHECK_THROWS_WITH(daemon::make_plan(config, std::nullopt), ContainsSubstring("link.baud is too slow"));
  config.link.period_s = 0.05;
  CHECK_NOTHROW(daemon::make_plan(config, std::nullopt));
}
