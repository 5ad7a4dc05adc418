#include "tools/wheelwright/import/mapping/given_mapping.hpp"

#include <algorithm>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "config/load/yaml_reader.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"

namespace wheelwright::import {
namespace {

using config::YamlReader;

// Keys of a file that was read strictly, as they stand there: the order and the defaults do not matter.
constexpr std::string_view known_keys[] = {"time.column",
                                           "time.unit",
                                           "time.period_s",
                                           "time.rate_hz",
                                           "command.kind",
                                           "command.left",
                                           "command.right",
                                           "command.linear",
                                           "command.angular",
                                           "command.velocity",
                                           "command.radius",
                                           "command.curvature",
                                           "command.throttle",
                                           "command.steering",
                                           "command.steering_gain",
                                           "command.left_direction",
                                           "command.right_direction",
                                           "command.forward",
                                           "command.neutral",
                                           "command.reversed",
                                           "command.timeout_s",
                                           "command.unit",
                                           "command.angular_unit",
                                           "command.full_scale",
                                           "command.full_scale_m_s",
                                           "wheels.kind",
                                           "wheels.left",
                                           "wheels.right",
                                           "wheels.linear",
                                           "wheels.angular",
                                           "wheels.angular_unit",
                                           "wheels.bits",
                                           "wheels.unit",
                                           "wheels.per_row",
                                           "wheels.direction",
                                           "wheels.unwrap",
                                           "wheels.metres_per_count",
                                           "wheels.metres_per_count_right",
                                           "wheels.counts_per_turn",
                                           "wheels.wheel_radius_m",
                                           "wheels.scale_from",
                                           "wheels.reversed",
                                           "reference.x",
                                           "reference.y",
                                           "reference.theta",
                                           "reference.roll",
                                           "reference.qx",
                                           "reference.qy",
                                           "reference.qz",
                                           "reference.qw",
                                           "reference.unit",
                                           "reference.metres_per_pixel",
                                           "reference.scale_from",
                                           "reference.angle_unit",
                                           "reference.heading",
                                           "reference.y_axis",
                                           "reference.heading_offset_deg",
                                           "reference.clock",
                                           "reference.topic",
                                           "reference.shift_s",
                                           "reference.clock_rate",
                                           "gyro.column",
                                           "gyro.unit",
                                           "gyro.lsb_per_deg_s",
                                           "battery.column",
                                           "battery.unit",
                                           "robot.name",
                                           "robot.wheel_base_m"};

std::vector<MappingEntry> said_in(YamlReader file, const std::string& source) {
  std::vector<MappingEntry> entries;
  for (const std::string_view key : known_keys) {
    const auto dot = key.find('.');
    auto section = file.section(key.substr(0, dot));
    if (section && section->has(key.substr(dot + 1))) {
      entries.push_back({std::string(key), section->text(key.substr(dot + 1)), source});
    }
  }
  return entries;
}

MappingEntry parse_setting(const std::string& setting) {
  const auto equals = setting.find('=');
  const std::string key = setting.substr(0, equals);
  const auto* const known = std::ranges::find(known_keys, std::string_view(key));
  if (equals == std::string::npos || known == std::end(known_keys)) {
    const std::vector<std::string> keys(std::begin(known_keys), std::end(known_keys));
    const std::string nearest = config::nearest_word(key, keys);
    const std::string such = nearest.empty() ? "robot.wheel_base_m" : nearest;
    throw config::ConfigError("--set " + config::excerpt(setting) +
                              (equals == std::string::npos
                                   ? ": must be KEY=VALUE, such as " + such + "=..."
                                   : ": there is no such key; did you mean " + such + "?"));
  }
  return {key, setting.substr(equals + 1), "--set " + config::excerpt(setting)};
}

// A rate is the inverse of a period, which has a key of its own.
void as_period(MappingEntry& entry) {
  if (entry.key != "time.rate_hz") return;
  entry.value = config::plain_number(*to_mapping({entry}, entry.source).time.period_s);
  entry.key = "time.period_s";
}

}  // namespace

GivenMapping::GivenMapping(const std::filesystem::path& file, const std::vector<std::string>& settings) {
  if (!file.empty()) {
    check_mapping_file(file);
    entries_ = said_in(YamlReader::load(file), file.string());
    std::ranges::for_each(entries_, as_period);
  }
  for (const auto& setting : settings) {
    MappingEntry entry = parse_setting(setting);
    to_mapping({entry}, entry.source);
    as_period(entry);
    std::erase_if(entries_, [&](const MappingEntry& before) { return before.key == entry.key; });
    entries_.push_back(entry);
  }
}

GivenMapping GivenMapping::with(std::string_view key, const std::string& value) const {
  GivenMapping result = *this;
  std::erase_if(result.entries_, [key](const MappingEntry& before) { return before.key == key; });
  result.entries_.push_back({std::string(key), value});
  return result;
}

const std::string* GivenMapping::find(std::string_view key) const {
  const auto at = std::ranges::find(entries_, key, &MappingEntry::key);
  return at == entries_.end() ? nullptr : &at->value;
}

}  // namespace wheelwright::import
