// The paper's calibration C on a simulated robot: normally distributed random commands.
#pragma once

#include <cstdint>

#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "model/brain/mission.hpp"
#include "model/drive_log.hpp"

namespace wheelwright::tools {

// Drives a robot that stands and returns its log, which starts from rest. The log is short where the robot
// stops by itself.
DriveLog drive_randomly(simulation::SimulatedRobot& robot, const roomba::LinkConfig& link,
                        const RobotLimits& limits, const WheelPair& metres_per_tick, double duration_s,
                        std::uint64_t seed);

}  // namespace wheelwright::tools
