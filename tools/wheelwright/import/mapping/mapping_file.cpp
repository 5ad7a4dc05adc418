#include "tools/wheelwright/import/mapping/mapping_file.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "config/load/yaml_reader.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::Range;
using config::YamlReader;

std::optional<ChannelName> channel(YamlReader& from, std::string_view key) {
  if (!from.has(key)) return std::nullopt;
  return channel_name(from.text(key));
}

std::optional<double> number(YamlReader& from, std::string_view key, const Range& range) {
  if (!from.has(key)) return std::nullopt;
  return from.number(key, range);
}

std::string unit(YamlReader& from, std::string_view key, std::span<const Unit> units,
                 const std::string& otherwise) {
  std::string name = from.text(key, otherwise);
  if (name.empty()) return name;
  if (const auto found = find_unit(units, name)) return std::string(found->name);
  std::string right;
  for (const auto& known : units) right += (right.empty() ? "" : ", ") + std::string(known.name);
  from.fail(key, "'" + config::excerpt(name) + "' is no unit here; must be one of " + right);
}

TimeMapping read_time(YamlReader& from) {
  TimeMapping time;
  time.column = channel(from, "column");
  time.unit = from.choice<TimeUnit>("unit",
                                    {{"s", TimeUnit::s},
                                     {"cs", TimeUnit::cs},
                                     {"ms", TimeUnit::ms},
                                     {"us", TimeUnit::us},
                                     {"ns", TimeUnit::ns},
                                     {"hms", TimeUnit::hms},
                                     {"day", TimeUnit::day},
                                     {"min", TimeUnit::min},
                                     {"h", TimeUnit::h},
                                     {"frame", TimeUnit::frame},
                                     {"iso", TimeUnit::iso}},
                                    time.unit);
  time.period_s = number(from, "period_s", {0.0001, 10, "s"});
  const auto rate_hz = number(from, "rate_hz", {0.1, 10'000, "Hz"});
  if (rate_hz) time.period_s = 1.0 / *rate_hz;
  return time;
}

// Left and right.
std::pair<bool, bool> read_reversed(YamlReader& from) {
  const std::string reversed = from.choice<std::string>(
      "reversed", {{"none", "none"}, {"left", "left"}, {"right", "right"}, {"both", "both"}}, "none");
  return {reversed == "left" || reversed == "both", reversed == "right" || reversed == "both"};
}

std::optional<CommandMapping> read_command(YamlReader& from) {
  CommandMapping command;
  const bool is_twist = from.has("linear") || from.has("angular");
  const bool is_throttle = from.has("throttle") || from.has("steering");
  command.kind = from.choice<CommandKind>("kind",
                                          {{"wheels", CommandKind::wheels},
                                           {"twist", CommandKind::twist},
                                           {"duty", CommandKind::duty},
                                           {"throttle", CommandKind::throttle}},
                                          is_twist      ? CommandKind::twist
                                          : is_throttle ? CommandKind::throttle
                                                        : CommandKind::wheels);
  command.by_curvature = from.has("curvature");
  command.by_radius = from.has("velocity") || from.has("radius") || command.by_curvature;
  const auto first = channel(from, is_twist            ? "linear"
                                   : is_throttle       ? "throttle"
                                   : command.by_radius ? "velocity"
                                                       : "left");
  command.second = channel(from, is_twist               ? "angular"
                                 : is_throttle          ? "steering"
                                 : command.by_curvature ? "curvature"
                                 : command.by_radius    ? "radius"
                                                        : "right");
  if ((is_twist != (command.kind == CommandKind::twist) ||
       is_throttle != (command.kind == CommandKind::throttle)) &&
      first) {
    from.fail(
        "kind",
        "a twist has the keys linear and angular, a throttle has throttle and steering, wheels and duty "
        "have left and right");
  }
  command.direction = {channel(from, "left_direction"), channel(from, "right_direction")};
  command.forward = from.number("forward", {-1e6, 1e6}, command.forward);
  const auto [left_reversed, right_reversed] = read_reversed(from);
  command.left_reversed = left_reversed;
  command.right_reversed = right_reversed;
  command.timeout_s = number(from, "timeout_s", {0.01, 60, "s"});
  command.neutral = from.number("neutral", {-1e6, 1e6}, command.neutral);
  command.steering_gain = from.number("steering_gain", {-1000, 1000}, command.steering_gain);
  command.unit =
      unit(from, "unit", speed_units(), command.by_radius && !command.by_curvature ? "mm/s" : command.unit);
  command.angular_unit = unit(from, "angular_unit", angular_units(), command.angular_unit);
  command.full_scale = from.number("full_scale", {1e-6, 1e9}, command.full_scale);
  command.full_scale_m_s = number(from, "full_scale_m_s", {0.001, 100, "m/s"});
  if (!first) return std::nullopt;
  command.first = *first;
  return command;
}

std::span<const Unit> units_of(WheelKind kind) {
  if (kind == WheelKind::speed) return speed_units();
  return kind == WheelKind::angle ? angle_units() : distance_units();
}

// Where the kind is still to be found, any unit of a wheel may be said.
std::string read_wheel_unit(YamlReader& from, WheelKind kind) {
  if (from.has("kind") || kind == WheelKind::speed) {
    if (kind == WheelKind::counts) return from.text("unit", "");
    return unit(from, "unit", units_of(kind), std::string(units_of(kind).front().name));
  }
  const std::string name = from.text("unit", "");
  for (const auto units : {distance_units(), angle_units()}) {
    if (const auto found = find_unit(units, name)) return std::string(found->name);
  }
  return name.empty() ? name : unit(from, "unit", speed_units(), "");
}

std::optional<WheelMapping> read_wheels(YamlReader& from) {
  WheelMapping wheels;
  wheels.kind = from.choice<WheelKind>("kind",
                                       {{"counts", WheelKind::counts},
                                        {"angle", WheelKind::angle},
                                        {"distance", WheelKind::distance},
                                        {"speed", WheelKind::speed}},
                                       wheels.kind);
  wheels.body_motion = from.has("linear") || from.has("angular");
  if (!from.has("kind") && (wheels.body_motion || find_unit(speed_units(), from.text("unit", ""))))
    wheels.kind = WheelKind::speed;
  const auto left = channel(from, wheels.body_motion ? "linear" : "left");
  wheels.right = channel(from, wheels.body_motion ? "angular" : "right");
  if (from.has("bits")) wheels.bits = static_cast<int>(from.integer("bits", {8, 32}));
  wheels.unit = read_wheel_unit(from, wheels.kind);
  wheels.angular_unit =
      unit(from, "angular_unit", wheels.kind == WheelKind::speed ? angular_units() : angle_units(), "");
  wheels.per_row = from.boolean("per_row", false);
  wheels.by_command_sign = from.choice<bool>("direction", {{"counted", false}, {"command", true}}, false);
  wheels.unwrap_by_command = from.choice<bool>("unwrap", {{"nearest", false}, {"command", true}}, false);
  wheels.metres_per_count = number(from, "metres_per_count", {1e-9, 1, "m"});
  wheels.metres_per_count_right = number(from, "metres_per_count_right", {1e-9, 1, "m"});
  wheels.counts_per_turn = number(from, "counts_per_turn", {1, 1e8});
  wheels.wheel_radius_m = number(from, "wheel_radius_m", {0.001, 2, "m"});
  wheels.scale_from = from.choice<std::string>(
      "scale_from", {{"stated", ""}, {"commands", "commands"}, {"reference", "reference"}}, "");
  const auto [left_reversed, right_reversed] = read_reversed(from);
  wheels.left_reversed = left_reversed;
  wheels.right_reversed = right_reversed;
  if (!left) return std::nullopt;
  wheels.left = *left;
  return wheels;
}

// Places on the globe and in an image are in no unit of distance.
std::string read_place_unit(YamlReader& from) {
  std::string name = from.text("unit", "m");
  if (name == geographic_unit || name == pixel_unit) return name;
  return unit(from, "unit", distance_units(), "m");
}

std::optional<ReferenceMapping> read_reference(YamlReader& from) {
  ReferenceMapping reference;
  reference.x = channel(from, "x");
  reference.y = channel(from, "y");
  reference.theta = channel(from, "theta");
  reference.qx = channel(from, "qx");
  reference.qy = channel(from, "qy");
  reference.qz = channel(from, "qz");
  reference.qw = channel(from, "qw");
  reference.roll = channel(from, "roll");
  reference.unit = read_place_unit(from);
  reference.scale_from_robot = from.choice<bool>("scale_from", {{"stated", false}, {"robot", true}}, false);
  reference.metres_per_pixel = number(from, "metres_per_pixel", {1e-6, 10, "m"});
  reference.angle_unit = unit(from, "angle_unit", angle_units(), reference.angle_unit);
  reference.clock = from.choice<ReferenceClock>(
      "clock", {{"same", ReferenceClock::same}, {"shifted", ReferenceClock::shifted}}, reference.clock);
  reference.clockwise =
      from.choice<bool>("heading", {{"counterclockwise", false}, {"clockwise", true}}, false);
  reference.y_points_right = from.choice<bool>("y_axis", {{"left", false}, {"right", true}}, false);
  reference.heading_offset_deg = number(from, "heading_offset_deg", {-360, 360, "deg"});
  reference.shift_s = number(from, "shift_s", {-1e12, 1e12, "s"});
  reference.clock_rate = number(from, "clock_rate", {0.5, 2, "s/s"});
  from.text("topic", "");  // which stream it is taken from, where names are found
  if (!reference.x && !reference.theta && !reference.qw) return std::nullopt;
  return reference;
}

std::optional<ScalarMapping> read_scalar(YamlReader& from, std::span<const Unit> units) {
  const auto column = channel(from, "column");
  const std::string name = unit(from, "unit", units, std::string(units.front().name));
  if (!column) return std::nullopt;
  return ScalarMapping{*column, name};
}

// Raw numbers have a scale of their own.
std::optional<ScalarMapping> read_gyro(YamlReader& from) {
  const auto scale = number(from, "lsb_per_deg_s", {0.01, 1e6});
  if (from.has("unit") && from.text("unit") == raw_unit) {
    const auto column = channel(from, "column");
    return column ? std::optional(ScalarMapping{*column, std::string(raw_unit), scale}) : std::nullopt;
  }
  auto gyro = read_scalar(from, angular_units());
  if (gyro && scale) {
    gyro->unit = raw_unit;
    gyro->lsb_per_deg_s = scale;
  }
  return gyro;
}

Mapping read_mapping(YamlReader file) {
  Mapping mapping;
  file.integer("wheelwright_mapping", {1, 1});
  if (auto section = file.section("time")) {
    mapping.time = read_time(*section);
    section->finish();
  }
  if (auto section = file.section("command")) {
    mapping.command = read_command(*section);
    section->finish();
  }
  if (auto section = file.section("wheels")) {
    mapping.wheels = read_wheels(*section);
    section->finish();
  }
  if (auto section = file.section("reference")) {
    mapping.reference = read_reference(*section);
    section->finish();
  }
  if (auto section = file.section("gyro")) {
    mapping.gyro = read_gyro(*section);
    section->finish();
  }
  if (auto section = file.section("battery")) {
    mapping.battery = read_scalar(*section, voltage_units());
    section->finish();
  }
  if (auto section = file.section("robot")) {
    mapping.robot = section->text("name", "");
    mapping.wheel_base_m = number(*section, "wheel_base_m", {0.001, 10, "m"});
    section->finish();
  }
  file.finish();
  return mapping;
}

// Stands for the text that keys and values make, of which no person knows the lines.
constexpr const char* entries_name = "mapping";

// "mapping:3:9: what" as "--set wheels.unit=foo: what".
std::string at_its_source(const std::string& message, const MappingText& text, const std::string& name) {
  const std::string prefix = std::string(entries_name) + ":";
  if (!message.starts_with(prefix)) return name + ": " + message;
  std::size_t line = 0;
  const char* const begin = message.data() + prefix.size();
  const auto [end, error] = std::from_chars(begin, message.data() + message.size(), line);
  const auto colon = message.find(": ", prefix.size());
  if (error != std::errc() || end == begin || colon == std::string::npos) return name + ": " + message;
  const std::string what = message.substr(colon + 2);
  const MappingEntry* entry = line >= 1 && line <= text.lines.size() ? text.lines[line - 1] : nullptr;
  if (entry == nullptr) return name + ": " + what;
  const std::string where = entry->source.empty()
                                ? name + ": " + entry->key + " '" + config::excerpt(entry->value) + "'"
                            : entry->source.starts_with("--set") ? entry->source
                                                                 : entry->source + ": " + entry->key;
  // Every key is known here: it is of another kind than the others say.
  if (what.starts_with("unknown key"))
    return where + ": " + entry->key +
           " does not go with the other keys of its section; leave it out, or them";
  return where + ": " + what;
}

}  // namespace

Mapping to_mapping(const std::vector<MappingEntry>& entries, const std::string& name) {
  const MappingText text = mapping_text(entries);
  try {
    return read_mapping(YamlReader::parse(text.text, entries_name));
  } catch (const config::ConfigError& error) {
    throw config::ConfigError(at_its_source(error.what(), text, name));
  }
}

void check_mapping_file(const std::filesystem::path& file) {
  read_mapping(YamlReader::load(file));
}

}  // namespace wheelwright::import
