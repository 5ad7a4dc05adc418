#include "daemon/wiring/plan.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "model/brain/route_forecast.hpp"

namespace wheelwright::daemon {
namespace {

using config::ConfigError;

std::string_view name_of(ModelType type) {
  return type == ModelType::arma ? "arma" : "fir";
}

// A source named after a type of model wants a model of that type.
void check_type(const config::DaemonConfig& config, ModelType type, const std::string& what) {
  if (config.commanded_drive || !is_sensorless(config.pose_source)) return;
  const ModelType wanted = config.pose_source == PoseSource::arma ? ModelType::arma : ModelType::fir;
  if (type == wanted) return;
  throw ConfigError(what + " a model of type " + std::string(name_of(type)) + ", but run.pose_source is '" +
                    std::string(wheelwright::name_of(config.pose_source)) + "'; set it to '" +
                    std::string(name_of(type)) + "', or make a model of type " +
                    std::string(name_of(wanted)) + " (calibration.type, wheelwright fit --type)");
}

void check_model(const config::DaemonConfig& config, const RobotModel& model) {
  const std::string file = config.model_file.string();
  if (std::abs(model.linear_part.period_s / config.link.period_s - 1.0) > 0.005) {
    throw ConfigError(file + ": was made for another period than link.period_s; calibrate again");
  }
  check_type(config, model.linear_part.type, file + ": holds");
  if (!config.commanded_drive && config.pose_source == PoseSource::hybrid && !model.encoder_scale) {
    throw ConfigError(file +
                      ": has no encoder_scale, but run.pose_source is 'hybrid', which needs metres per tick; "
                      "calibrate again, or set it to '" +
                      std::string(name_of(model.linear_part.type)) + "'");
  }
}

}  // namespace

Plan make_plan(const config::DaemonConfig& config, std::optional<RobotModel> model) {
  Plan plan;
  plan.limits = config.limits;
  const bool calibrate =
      config.calibrate == config::CalibrateWhen::always ||
      (config.calibrate == config::CalibrateWhen::if_needed && !model && !config.commanded_drive);
  if (calibrate) {
    check_type(config, config.calibration_type, config.file.string() + ": calibration.type makes");
    plan.mission.encoder_turn = config.encoder_turn;
    if (config.response.repetitions > 0) plan.mission.response = config.response;
    if (config.calibration_type == ModelType::arma) {
      plan.mission.random_drive = config.random_drive;
      if (config.route) plan.mission.random_drive->tour_speed_m_s = config.route->speed_m_s;
    }
  } else if (model) {
    check_model(config, *model);
    plan.model = std::move(model);
    if (plan.model->encoder_scale) plan.limits.metres_per_tick = plan.model->encoder_scale->metres_per_tick;
  } else if (!config.commanded_drive && config.pose_source != PoseSource::odometry) {
    throw ConfigError(
        config.model_file.string() +
        ": no such model, and calibration.when is 'never'; calibrate once, or drive by odometry");
  }
  plan.mission.route = config.route;
  plan.mission.commanded_drive = config.commanded_drive;
  plan.mission.pose_source = config.pose_source;
  plan.mission.adapt = config.adapt;
  plan.mission.largest_uncertainty_m = config.largest_uncertainty_m;
  if (plan.model) {
    if (const auto doubt = doubt_of_route(*plan.model, plan.mission, plan.limits))
      throw ConfigError(config.model_file.string() + ": " + doubt->reason);
  }
  return plan;
}

}  // namespace wheelwright::daemon
