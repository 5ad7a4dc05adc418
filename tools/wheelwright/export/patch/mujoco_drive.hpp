// The two driven wheels of an MJCF file.
#pragma once

#include "tools/wheelwright/export/mujoco.hpp"
#include "tools/wheelwright/export/patch/xml_file.hpp"

namespace wheelwright::tools {

struct MujocoWheel {
  pugi::xml_node actuator;
  pugi::xml_node joint;
  pugi::xml_node body;
  pugi::xml_node geom;  // nothing where `no_radius` says why
  std::string no_radius;
  std::string joint_name;
  std::string actuator_name;  // or that of its joint
};

struct MujocoDrive {
  MujocoWheel left;
  MujocoWheel right;
  std::string no_separation;  // why y of the bodies is not half of the distance between the wheels
  double timestep_s = 0.002;
};

// Throws UsageError, in one line, where there are no two wheels, or more.
MujocoDrive find_mujoco_drive(const XmlFile& file, const PatchNames& names);

// As the numbers have to be for it; fails for an actuator whose torque is another.
MujocoSide side_of(const XmlFile& file, const MujocoWheel& wheel);

}  // namespace wheelwright::tools
