// How a robot of an evaluation calibrates itself.
#pragma once

#include <cstdint>

#include "model/brain/mission.hpp"

namespace wheelwright::tools {

enum class Drives : std::uint8_t {
  shipped,  // the daemon's defaults
  paper,    // as the source paper describes them: short actions, and random commands alone
};

struct CalibrationDrives {
  ResponsePlan response;
  RandomDrivePlan random_drive;
};

// `speed_m_s` is that of the route which the model is for.
CalibrationDrives calibration_drives(Drives drives, double speed_m_s);

}  // namespace wheelwright::tools
