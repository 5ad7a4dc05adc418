#include "tools/wheelwright/import/formats/ros/echo/message_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "tools/wheelwright/import/formats/ros/messages/definition.hpp"
#include "tools/wheelwright/import/formats/ros/messages/known_definitions.hpp"

namespace wheelwright::import::ros {
namespace {

using Columns = std::span<const ColumnContent>;

// Of two types that look alike the first is taken.
constexpr std::array<std::string_view, 13> stamped_types{
    "nav_msgs/Odometry",
    "geometry_msgs/PoseStamped",
    "geometry_msgs/PoseWithCovarianceStamped",
    "geometry_msgs/TransformStamped",
    "geometry_msgs/TwistStamped",
    "geometry_msgs/TwistWithCovarianceStamped",
    "geometry_msgs/PointStamped",
    "geometry_msgs/QuaternionStamped",
    "sensor_msgs/Imu",
    "irobot_create_msgs/WheelTicks",
    "irobot_create_msgs/WheelVels",
    "geometry_msgs/Vector3Stamped",
    "geometry_msgs/AccelStamped",
};

struct ExpectedColumn {
  std::string name;
  bool is_text = false;
  bool is_whole = false;
};

bool is_text(const ColumnContent& column) {
  return !column.texts.empty();
}

bool is_empty(const ColumnContent& column) {
  return !is_text(column) &&
         std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
}

bool is_whole(const ColumnContent& column) {
  return !is_text(column) &&
         std::ranges::all_of(column.values, [](double value) { return std::trunc(value) == value; });
}

// Seconds that never fall, and beside them nanoseconds.
bool begins_with_header(Columns columns) {
  constexpr double nanoseconds = 1e9;
  if (columns.size() < 4 || !is_whole(columns[0]) || !is_whole(columns[1])) return false;
  if (!is_text(columns[2]) && !is_empty(columns[2])) return false;
  const bool are_parts = std::ranges::all_of(
      columns[1].values, [](double value) { return value >= 0.0 && value < nanoseconds; });
  const bool are_fine =
      std::ranges::any_of(columns[1].values, [](double value) { return value > 0.001 * nanoseconds; });
  return are_parts && are_fine && std::ranges::is_sorted(columns[0].values);
}

bool is_of_whole_numbers(FieldKind kind) {
  return kind != FieldKind::float32 && kind != FieldKind::float64;
}

void expand(const MessageDefinition& definition, std::size_t type, const std::string& prefix,
            std::vector<ExpectedColumn>& expanded) {
  for (const Field& field : definition.types[type].fields) {
    const std::string name = prefix + field.name;
    if (field.kind == FieldKind::message) {
      expand(definition, field.type, name + ".", expanded);
    } else if (field.kind == FieldKind::ros2_time) {
      expanded.push_back({name + ".sec", false, true});
      expanded.push_back({name + ".nanosec", false, true});
    } else if (field.arity == Arity::fixed) {
      for (std::uint32_t i = 0; i < field.count; ++i)
        expanded.push_back({name + "[" + std::to_string(i) + "]", false, false});
    } else {
      expanded.push_back({name, field.kind == FieldKind::string, is_of_whole_numbers(field.kind)});
    }
  }
}

std::vector<ExpectedColumn> columns_of(std::string_view type) {
  std::vector<ExpectedColumn> expanded;
  const auto text = known_definition(type);
  const auto definition = text ? parse_definition(type, *text, Dialect::ros2)
                               : tl::expected<MessageDefinition, std::string>(tl::unexpected(std::string()));
  if (definition) expand(*definition, 0, "", expanded);
  return expanded;
}

bool fit(const std::vector<ExpectedColumn>& expected, Columns columns) {
  if (expected.size() != columns.size()) return false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (is_empty(columns[i]) && expected[i].is_text) continue;
    if (is_text(columns[i]) != expected[i].is_text) return false;
    if (expected[i].is_whole && !expected[i].is_text && !is_whole(columns[i])) return false;
  }
  return true;
}

// Of each quaternion the squares sum to one; where nothing was measured all four are zero.
bool has_quaternions(const std::vector<ExpectedColumn>& expected, Columns columns) {
  constexpr double tolerance = 0.01;
  for (std::size_t i = 0; i + 3 < expected.size(); ++i) {
    const bool begins = expected[i].name.ends_with("orientation.x") ||
                        expected[i].name.ends_with("rotation.x") || expected[i].name == "quaternion.x";
    if (!begins) continue;
    for (std::size_t row = 0; row < columns[i].values.size(); ++row) {
      double sum = 0.0;
      for (std::size_t part = i; part < i + 4; ++part) sum += std::pow(columns[part].values[row], 2);
      if (sum > 0.0 && std::abs(sum - 1.0) > tolerance) return false;
    }
  }
  return true;
}

constexpr std::size_t header_width = 3;

std::vector<std::string> header_names() {
  return {"header.stamp.sec", "header.stamp.nanosec", "header.frame_id"};
}

// sensor_msgs/JointState: the names of the joints, then their positions, speeds and efforts, as far as the
// robot gives them.
std::optional<MessageColumns> joint_states(Columns columns) {
  std::size_t joints = 0;
  while (header_width + joints < columns.size() && is_text(columns[header_width + joints])) ++joints;
  const std::size_t numbers = columns.size() - header_width - joints;
  if (joints == 0 || numbers == 0 || numbers % joints != 0 || numbers > 3 * joints) return std::nullopt;
  const auto joint = [&](std::size_t i) { return columns[header_width + i].texts.front(); };
  MessageColumns message{"sensor_msgs/JointState", header_names()};
  for (std::size_t i = 0; i < joints; ++i) message.names.push_back("name[" + std::to_string(i) + "]");
  constexpr std::array fields{"position", "velocity", "effort"};
  for (std::size_t i = 0; i < numbers; ++i) {
    if (is_text(columns[header_width + joints + i])) return std::nullopt;
    message.names.push_back(std::string(fields.at(i / joints)) + "[" + joint(i % joints) + "]");
  }
  return message;
}

}  // namespace

std::optional<MessageColumns> recognise_message(Columns columns) {
  if (!begins_with_header(columns)) return std::nullopt;
  for (const std::string_view type : stamped_types) {
    const auto expected = columns_of(type);
    if (!fit(expected, columns) || !has_quaternions(expected, columns)) continue;
    MessageColumns message{std::string(type), {}};
    for (const ExpectedColumn& column : expected) message.names.push_back(column.name);
    return message;
  }
  if (auto message = joint_states(columns)) return message;
  if (is_empty(columns[2])) return std::nullopt;
  MessageColumns message{"", header_names()};
  for (std::size_t i = header_width; i < columns.size(); ++i)
    message.names.push_back(std::to_string(i + 1 - header_width));
  return message;
}

}  // namespace wheelwright::import::ros
