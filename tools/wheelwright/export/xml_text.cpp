#include "tools/wheelwright/export/xml_text.hpp"

namespace wheelwright::tools {

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
