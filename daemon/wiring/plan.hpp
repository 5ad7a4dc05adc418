// What a run is to do: calibration only where it is wanted, or where nothing is known yet.
#pragma once

#include <optional>

#include "config/load/daemon_config.hpp"
#include "model/brain/mission.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

struct Plan {
  Mission mission;
  RobotLimits limits;               // with the encoder scale of the model, where there is one
  std::optional<RobotModel> model;  // what the run starts with
};

// `model` is what the model file holds, if there is one. Throws ConfigError where the mission needs one, or
// another: of the period of the link, of the type that the pose source is named after, and for the source
// `hybrid` with an encoder scale; and where the model cannot hold the route within run.largest_uncertainty_m.
// Given commands are driven with a model or without.
Plan make_plan(const config::DaemonConfig& config, std::optional<RobotModel> model);

}  // namespace wheelwright::daemon
