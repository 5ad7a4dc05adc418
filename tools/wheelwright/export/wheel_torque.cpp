#include "tools/wheelwright/export/wheel_torque.hpp"

namespace wheelwright::tools {

std::optional<WheelTorque> wheel_torque(const DriveFigures& figures, double lag_s,
                                        const WheelGeometry& wheel) {
  if (!wheel.inertia_kg_m2 || !(lag_s > 0.0)) return std::nullopt;
  const double damping = *wheel.inertia_kg_m2 / lag_s;
  if (!figures.friction_loss_m_s) return WheelTorque{damping, Figure{}, "the model has no friction"};
  const Figure friction = scaled(*figures.friction_loss_m_s, damping / wheel.radius_m);
  return WheelTorque{
      damping, friction,
      "of a speed loss of " + value_of(*figures.friction_loss_m_s) + " m/s: " + remark_of(friction)};
}

std::string in_xml_comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.insert(at + 1, " ");
  return text;
}

std::string xml_head(const std::string& kind, const RobotModel& model, const ModelNumbers& numbers) {
  std::string text = "<!-- " + kind + ": 1\n     " + in_xml_comment(origin_of(model)) + "\n     " +
                     in_xml_comment(numbers.notes) + "\n";
  for (const auto& [effect, reason] : numbers.unsaid) {
    text += "     " + in_xml_comment(effect + ": cannot be said in this format: " + reason) + "\n";
  }
  return text + "-->\n";
}

std::string xml_remarks(const std::string& indent, const std::vector<PlacedNumber>& numbers) {
  const std::string remarks = remarks_on(numbers);
  if (remarks.empty()) return "";
  return indent + "<!-- " + std::string(remark_mark) + " " + in_xml_comment(remarks) + " -->\n";
}

std::string attribute_text(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

}  // namespace wheelwright::tools
