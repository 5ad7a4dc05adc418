// What a physics engine wants of a wheel: torques, of which a model of speeds knows nothing but their ratios.
//
// A drive that follows its command with a lag is a motor whose torque is damping (command - speed); friction
// that costs a speed is damping times that speed. How large the damping is, hangs on what it has to speed up.
#pragma once

#include <optional>
#include <string>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

struct WheelGeometry {
  double radius_m = 0.0;
  // What one wheel's motor speeds up, at the wheel: its own inertia, and the radius squared times half of the
  // robot's mass. Without it there are no torques.
  std::optional<double> inertia_kg_m2;
};

struct WheelTorque {
  double damping_n_m_s = 0.0;  // N m per rad/s
  Figure friction_n_m;
  std::string friction_remark;
};

// Nothing without an inertia, or where the linear part answers at once.
std::optional<WheelTorque> wheel_torque(const DriveFigures& figures, double lag_s,
                                        const WheelGeometry& wheel);

// A text that may stand in an XML comment.
std::string in_xml_comment(std::string text);

// The first comment of a fragment: its kind, the origin, and what is unsaid.
std::string xml_head(const std::string& kind, const RobotModel& model, const ModelNumbers& numbers);

// Marks the comments that a patch may replace.
inline constexpr std::string_view remark_mark = "wheelwright:";

// The comment on some numbers, in a line of its own; nothing where none has a remark.
std::string xml_remarks(const std::string& indent, const std::vector<PlacedNumber>& numbers);

// ` name="value"`.
std::string attribute_text(const std::string& name, const std::string& value);

}  // namespace wheelwright::tools
