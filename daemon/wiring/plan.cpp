#include "daemon/wiring/plan.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "config/load/text_format.hpp"
#include "drivers/open_interface/query_reader.hpp"
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

// A reply has to come whole within its period.
void check_baud(const config::DaemonConfig& config) {
  constexpr double bits_per_byte = 10.0;
  const auto bytes = static_cast<double>(open_interface::QueryReader().reply_bytes());
  const double reply_ms = 1e3 * bytes * bits_per_byte / config.baud;
  if (reply_ms < 1e3 * config.link.period_s) return;
  throw ConfigError(config.file.string() + ": link.baud is too slow: the sensors of one period take " +
                    config::fixed_number(reply_ms, 1) + " ms, but link.period_s is " +
                    config::fixed_number(1e3 * config.link.period_s, 1) +
                    " ms; set it to 115200, or give a longer period");
}

void check_model(const config::DaemonConfig& config, const RobotModel& model) {
  const std::string file = config.model_file.string();
  if (std::abs(model.linear_part.period_s / config.link.period_s - 1.0) > 0.005) {
    throw ConfigError(file + ": was made for another period than link.period_s; calibrate again");
  }
  const double base_m = model.linear_part.wheel_base_m;
  if (std::abs(base_m / config.limits.wheel_base_m - 1.0) > 0.001) {
    throw ConfigError(file + ": was made with a wheel base of " + config::plain_number(base_m) +
                      " m, but robot.wheel_base_m is " + config::plain_number(config.limits.wheel_base_m) +
                      " m; calibrate again, or set it to that of the model");
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
  check_baud(config);
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
