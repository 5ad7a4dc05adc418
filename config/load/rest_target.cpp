#include "config/load/rest_target.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <exception>

#include "config/load/text_file.hpp"
#include "config/load/yaml_bounds.hpp"

namespace wheelwright::config {
namespace {

constexpr int max_cuts = 100;
constexpr FileKind configuration{"a configuration", 1U << 20U};

// The first `count` lines of a text.
std::string first_lines(const std::string& text, int count) {
  std::size_t end = 0;
  for (int line = 0; line < count && end != std::string::npos; ++line) end = text.find('\n', end + 1);
  return end == std::string::npos ? text : text.substr(0, end);
}

// The document up to the line that is no YAML.
YAML::Node readable_part(const std::string& text) {
  std::string part = text;
  for (int cut = 0; cut < max_cuts && !part.empty(); ++cut) {
    try {
      check_yaml_bounds(part);
      return YAML::Load(part);
    } catch (const YAML::Exception& error) {
      const int lines = static_cast<int>(std::count(part.begin(), part.end(), '\n')) + 1;
      part = first_lines(part, std::clamp(error.mark.line, 0, lines - 1));
    }
  }
  return {};
}

std::string text_of(const YAML::Node& section, const char* key) {
  const YAML::Node value = section[key];
  return value && value.IsScalar() ? value.Scalar() : std::string();
}

}  // namespace

RestTarget rest_target(const DaemonConfig& config) {
  return {config.device, config.baud, config.link.drive_mode};
}

std::string rest_target_to_yaml(const RestTarget& target) {
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "link" << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "device" << YAML::Value << YAML::DoubleQuoted << target.device.string();
  out << YAML::Key << "baud" << YAML::Value << target.baud;
  out << YAML::Key << "drive" << YAML::Value
      << (target.drive_mode == roomba::DriveMode::pwm ? "pwm" : "direct");
  out << YAML::EndMap << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

std::optional<RestTarget> salvage_rest_target(const std::filesystem::path& file) {
  try {
    const YAML::Node document = readable_part(read_text_or_throw<ConfigError>(file, configuration));
    if (!document.IsMap()) return std::nullopt;
    const YAML::Node link = document["link"];
    if (!link || !link.IsMap()) return std::nullopt;
    RestTarget target;
    target.device = text_of(link, "device");
    if (target.device.empty()) return std::nullopt;
    if (text_of(link, "baud") == "19200") target.baud = 19200;
    if (text_of(link, "drive") == "pwm") target.drive_mode = roomba::DriveMode::pwm;
    return target;
  } catch (const std::exception&) {
    return std::nullopt;  // there is another place to look
  }
}

}  // namespace wheelwright::config
