#include "tools/wheelwright/import/mapping/mapping.hpp"

#include <algorithm>
#include <array>

#include "config/load/text_format.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

constexpr std::array<std::string_view, 11> time_unit_names{"s",  "ms",  "us",    "ns",  "hms", "iso",
                                                           "cs", "day", "frame", "min", "h"};
constexpr std::array<std::string_view, 4> command_kind_names{"wheels", "twist", "duty", "throttle"};
constexpr std::array<std::string_view, 4> wheel_kind_names{"counts", "angle", "distance", "speed"};

template <typename Names, typename Value>
std::string name_of(const Names& names, Value value) {
  return std::string(names.at(static_cast<std::size_t>(value)));
}

class Entries {
 public:
  void add(std::string key, std::string value) { list_.push_back({std::move(key), std::move(value)}); }
  void add(std::string key, const std::optional<ChannelName>& channel) {
    if (channel) add(std::move(key), channel->text());
  }
  void add(std::string key, const std::optional<double>& number) {
    if (number) add(std::move(key), plain_number(*number));
  }
  std::vector<MappingEntry> take() { return std::move(list_); }

 private:
  std::vector<MappingEntry> list_;
};

void add_time(Entries& entries, const TimeMapping& time) {
  entries.add("time.column", time.column);
  if (time.column) entries.add("time.unit", name_of(time_unit_names, time.unit));
  entries.add("time.period_s", time.period_s);
}

void add_reversed(Entries& entries, const std::string& key, bool left, bool right) {
  if (left || right) entries.add(key, left && right ? "both" : left ? "left" : "right");
}

void add_command(Entries& entries, const CommandMapping& command) {
  const bool is_twist = command.kind == CommandKind::twist;
  entries.add("command.kind", name_of(command_kind_names, command.kind));
  const bool is_throttle = command.kind == CommandKind::throttle;
  entries.add(is_twist            ? "command.linear"
              : is_throttle       ? "command.throttle"
              : command.by_radius ? "command.velocity"
                                  : "command.left",
              command.first.text());
  entries.add(is_twist               ? "command.angular"
              : is_throttle          ? "command.steering"
              : command.by_curvature ? "command.curvature"
              : command.by_radius    ? "command.radius"
                                     : "command.right",
              command.second);
  entries.add("command.left_direction", command.direction[0]);
  entries.add("command.right_direction", command.direction[1]);
  if (command.direction[0]) entries.add("command.forward", command.forward);
  if (command.neutral != 0.0) entries.add("command.neutral", command.neutral);
  add_reversed(entries, "command.reversed", command.left_reversed, command.right_reversed);
  if (is_throttle) entries.add("command.steering_gain", command.steering_gain);
  entries.add("command.timeout_s", command.timeout_s);
  if (command.is_duty()) {
    entries.add("command.full_scale", command.full_scale);
    entries.add("command.full_scale_m_s", command.full_scale_m_s);
    return;
  }
  entries.add("command.unit", command.unit);
  if (is_twist) entries.add("command.angular_unit", command.angular_unit);
}

void add_wheels(Entries& entries, const WheelMapping& wheels) {
  entries.add("wheels.kind", name_of(wheel_kind_names, wheels.kind));
  entries.add(wheels.body_motion ? "wheels.linear" : "wheels.left", wheels.left.text());
  entries.add(wheels.body_motion ? "wheels.angular" : "wheels.right", wheels.right);
  if (wheels.bits) entries.add("wheels.bits", std::to_string(*wheels.bits));
  if (wheels.kind != WheelKind::counts) entries.add("wheels.unit", wheels.unit);
  if (!wheels.angular_unit.empty()) entries.add("wheels.angular_unit", wheels.angular_unit);
  if (wheels.per_row) entries.add("wheels.per_row", "true");
  if (wheels.by_command_sign) entries.add("wheels.direction", "command");
  if (wheels.unwrap_by_command) entries.add("wheels.unwrap", "command");
  entries.add("wheels.metres_per_count", wheels.metres_per_count);
  entries.add("wheels.metres_per_count_right", wheels.metres_per_count_right);
  entries.add("wheels.counts_per_turn", wheels.counts_per_turn);
  entries.add("wheels.wheel_radius_m", wheels.wheel_radius_m);
  if (!wheels.scale_from.empty()) entries.add("wheels.scale_from", wheels.scale_from);
  add_reversed(entries, "wheels.reversed", wheels.left_reversed, wheels.right_reversed);
}

void add_reference(Entries& entries, const ReferenceMapping& reference) {
  entries.add("reference.x", reference.x);
  entries.add("reference.y", reference.y);
  entries.add("reference.theta", reference.theta);
  entries.add("reference.roll", reference.roll);
  entries.add("reference.qx", reference.qx);
  entries.add("reference.qy", reference.qy);
  entries.add("reference.qz", reference.qz);
  entries.add("reference.qw", reference.qw);
  entries.add("reference.unit", reference.unit);
  entries.add("reference.metres_per_pixel", reference.metres_per_pixel);
  if (reference.scale_from_robot) entries.add("reference.scale_from", "robot");
  if (reference.theta) entries.add("reference.angle_unit", reference.angle_unit);
  if (reference.clockwise) entries.add("reference.heading", "clockwise");
  if (reference.y_points_right) entries.add("reference.y_axis", "right");
  entries.add("reference.heading_offset_deg", reference.heading_offset_deg);
  entries.add("reference.clock", reference.clock == ReferenceClock::same ? "same" : "shifted");
  entries.add("reference.shift_s", reference.shift_s);
  entries.add("reference.clock_rate", reference.clock_rate);
}

void add_scalar(Entries& entries, const std::string& section, const std::optional<ScalarMapping>& scalar) {
  if (!scalar) return;
  entries.add(section + ".column", scalar->column.text());
  entries.add(section + ".unit", scalar->unit);
  entries.add(section + ".lsb_per_deg_s", scalar->lsb_per_deg_s);
}

// A text that YAML would not take for something else.
std::string yaml_value(const std::string& value) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
  const bool is_plain = !value.empty() && value.find_first_not_of(plain) == std::string::npos && value != "-";
  return is_plain ? value : config::quoted(value);
}

}  // namespace

ChannelName channel_name(std::string_view text) {
  return {"", std::string(text)};
}

std::vector<MappingEntry> mapping_entries(const Mapping& mapping) {
  Entries entries;
  add_time(entries, mapping.time);
  if (mapping.command) add_command(entries, *mapping.command);
  if (mapping.wheels) add_wheels(entries, *mapping.wheels);
  if (mapping.reference) add_reference(entries, *mapping.reference);
  add_scalar(entries, "gyro", mapping.gyro);
  add_scalar(entries, "battery", mapping.battery);
  if (!mapping.robot.empty()) entries.add("robot.name", mapping.robot);
  entries.add("robot.wheel_base_m", mapping.wheel_base_m);
  return entries.take();
}

MappingText mapping_text(const std::vector<MappingEntry>& entries) {
  MappingText result{"wheelwright_mapping: 1\n", {nullptr}};
  std::vector<std::string> sections;
  const auto section_of = [](const MappingEntry& entry) { return entry.key.substr(0, entry.key.find('.')); };
  for (const auto& entry : entries) {
    if (std::ranges::find(sections, section_of(entry)) == sections.end())
      sections.push_back(section_of(entry));
  }
  for (const auto& section : sections) {
    result.text += section + ":\n";
    result.lines.push_back(nullptr);
    for (const auto& entry : entries) {
      if (section_of(entry) != section) continue;
      result.lines.push_back(&entry);
      result.text += "  " + entry.key.substr(std::min(section.size() + 1, entry.key.size())) + ": " +
                     yaml_value(entry.value) + "\n";
    }
  }
  return result;
}

}  // namespace wheelwright::import
