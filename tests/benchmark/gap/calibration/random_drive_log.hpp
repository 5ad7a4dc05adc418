// Drives of a model of this library, with noise: what a method must get right by itself before other robots
// can try it.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "model/log/drive_log.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::calibration {

// Standard deviations. Each wheel drifts on the floor, seen by the counts too.
struct DriveNoise {
  double reference_m = 0.001;
  double reference_rad = 0.002;
  double drift_m_per_sqrt_s = 0.0008;
};

struct DriveProgram {
  double duration_s = 60.0;
  double period_s = 0.018;
  double largest_m_s = 0.25;  // of a wheel
};

using Random = std::mt19937_64;

// Commands that hold for 0.4 to 2.5 s: straight on, backwards, arcs, turns on the spot, stops and ramps.
DriveLog random_commands(const DriveProgram& program, const std::string& name, Random& random);

// The same drive with what encoders and a reference measure while the model, with noise, follows the
// commands. Counts go on from what the wheels had rolled before.
DriveLog measured_drive(const RobotModel& model, DriveLog commands, const DriveNoise& noise,
                        const WheelPair& initial_travel_m, Random& random);

// By the counts at the end of a measured drive.
WheelPair rolled_m(const DriveLog& log);

}  // namespace wheelwright::calibration
