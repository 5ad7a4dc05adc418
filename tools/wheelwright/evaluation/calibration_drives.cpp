#include "tools/wheelwright/evaluation/calibration_drives.hpp"

namespace wheelwright::tools {
namespace {

// The four actions of the source paper, twice: one pass has too few samples for the responses of both wheels.
ResponsePlan four_actions() {
  ResponsePlan plan;
  plan.repetitions = 2;
  plan.speed_spread = 0.0;
  plan.alternate_direction = false;
  plan.on_s = 1.0;
  return plan;
}

}  // namespace

CalibrationDrives calibration_drives(Drives drives, double speed_m_s) {
  CalibrationDrives plan;
  plan.random_drive.tour_speed_m_s = speed_m_s;
  if (drives == Drives::paper) {
    plan.response = four_actions();
    plan.random_drive.tour_share = 0.0;
  }
  return plan;
}

}  // namespace wheelwright::tools
