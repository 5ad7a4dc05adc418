#include "daemon/plan.hpp"

#include <cmath>
#include <utility>

namespace wheelwright::daemon {

Plan make_plan(const config::DaemonConfig& config, std::optional<RobotModel> model) {
  Plan plan;
  plan.limits = config.limits;
  const bool calibrate = config.calibrate == config::CalibrateWhen::always ||
                         (config.calibrate == config::CalibrateWhen::if_needed && !model);
  if (calibrate) {
    plan.mission.encoder_turn = config.encoder_turn;
    plan.mission.response = config.response;
  } else if (model) {
    plan.model = std::move(model);
    if (plan.model->encoder_scale) plan.limits.metres_per_tick = plan.model->encoder_scale->metres_per_tick;
  } else if (config.pose_source != PoseSource::odometry) {
    throw config::ConfigError(
        config.model_file.string() +
        ": no such model, and calibration.when is 'never'; calibrate once, or drive by odometry");
  }
  if (plan.model && std::abs(plan.model->core.period_s / config.link.period_s - 1.0) > 0.005) {
    throw config::ConfigError(config.model_file.string() +
                              ": was made for another period than link.period_s; calibrate again");
  }
  plan.mission.route = config.route;
  plan.mission.pose_source = config.pose_source;
  return plan;
}

}  // namespace wheelwright::daemon
