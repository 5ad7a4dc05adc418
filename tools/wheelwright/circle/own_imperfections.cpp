#include "tools/wheelwright/circle/own_imperfections.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using simulation::SimulationConfig;
using simulation::WheelConfig;

// The larger of both wheels.
double largest(const SimulationConfig& robot, double WheelConfig::*field) {
  return std::max(robot.left.*field, robot.right.*field);
}

double largest_friction_nm(const SimulationConfig& robot, double simulation::FrictionConfig::*field) {
  return std::max(robot.left.friction.*field, robot.right.friction.*field);
}

}  // namespace

std::vector<Imperfection> own_imperfections(const SimulationConfig& robot) {
  std::vector<Imperfection> all;
  const auto add = [&](bool present, std::string what, std::vector<std::string> effects) {
    if (present) all.push_back({std::move(what), std::move(effects)});
  };
  const double unequal = robot.right.diameter_m / robot.left.diameter_m - 1.0;
  add(unequal != 0.0, "right wheel " + fixed_number(100.0 * unequal, 2) + " % larger than the left",
      {"wheel_scale_mismatch"});
  const double play_rad = largest(robot, &WheelConfig::backlash_rad);
  add(play_rad > 0.0, "gear play of " + fixed_number(1e3 * play_rad * 0.5 * robot.left.diameter_m, 2) + " mm",
      {"backlash"});
  add(largest(robot, &WheelConfig::eccentricity) > 0.0, "eccentric wheels", {"wheel_eccentricity"});
  const double friction_nm = largest_friction_nm(robot, &simulation::FrictionConfig::coulomb_nm);
  const double stiction_nm = largest_friction_nm(robot, &simulation::FrictionConfig::stiction_nm);
  add(friction_nm > 0.0, "dry friction of " + fixed_number(friction_nm, 3) + " Nm", {"coulomb_friction"});
  add(stiction_nm > friction_nm, "stiction of " + fixed_number(stiction_nm, 3) + " Nm", {"stiction"});
  add(!robot.left.motor.bridge_can_brake || !robot.right.motor.bridge_can_brake, "motors that cannot brake",
      {"asymmetric_response"});
  add(robot.chassis.yaw_scrub_nm > 0.0, "tyres that scrub", {"turn_scrub", "effective_track"});
  add(robot.chassis.caster.swivel_torque_nm > 0.0, "a caster that kicks", {"caster_kick"});
  add(robot.firmware.staircase, "firmware that knows speeds in steps", {"command_quantization"});
  return all;
}

}  // namespace wheelwright::tools
