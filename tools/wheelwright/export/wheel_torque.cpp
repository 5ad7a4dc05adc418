#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

std::optional<WheelTorque> wheel_torque(const DriveFigures& figures, double lag_s,
                                        const WheelGeometry& wheel) {
  if (!wheel.inertia_kg_m2 || !(lag_s > 0.0)) return std::nullopt;
  const double damping = *wheel.inertia_kg_m2 / lag_s;
  const double loss_m_s = figures.friction_loss_m_s ? figures.friction_loss_m_s->value : 0.0;
  return WheelTorque{damping, damping * loss_m_s / wheel.radius_m};
}

std::string in_xml_comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.insert(at + 1, " ");
  return text;
}

std::string xml_head(const std::string& kind, const RobotModel& model, const std::string& notes,
                     const std::vector<Unsaid>& unsaid) {
  std::string text = "<!-- " + kind + ": 1\n     " + in_xml_comment(origin_of(model)) + "\n     " +
                     in_xml_comment(notes) + "\n";
  for (const auto& [effect, reason] : unsaid) {
    text += "     " + in_xml_comment(effect + ": cannot be said in this format: " + reason) + "\n";
  }
  return text + "-->\n";
}

std::string xml_remark(const std::string& indent, const std::string& what, const Figure& figure) {
  return indent + "<!-- " + in_xml_comment(what + ": " + remark_of(figure)) + " -->\n";
}

}  // namespace wheelwright::tools
