// What a calibration found that is no fault of it, but that a person should look at.
#pragma once

#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "model/calibration/encoder_scale_fit.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

// Counts of a turn that the configuration does not let expect: mostly a wrong wheel base.
std::optional<std::string> remark_on_scale(const EncoderScaleFit& fit, const config::DaemonConfig& config);

// Wheels that answer to the same command by different speeds.
std::optional<std::string> remark_on_wheels(const RobotModel& model);

}  // namespace wheelwright::daemon
