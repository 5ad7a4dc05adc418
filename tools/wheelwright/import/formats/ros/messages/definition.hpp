// Message definitions: the .msg text of a type and, behind lines of "=", of every type that it is made of.
//
// Both dialects are read. ROS 1: wiki.ros.org/msg. ROS 2: docs.ros.org, "Interfaces", with bounds of strings
// and sequences, defaults, and constants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import::ros {

enum class Dialect { ros1, ros2 };

enum class FieldKind : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  ros1_time,      // two uint32: seconds, nanoseconds
  ros1_duration,  // two int32
  ros2_time,      // int32 seconds, uint32 nanoseconds; of durations too
  string,
  wide_string,
  message,
};
inline bool is_number(FieldKind kind) {
  return kind < FieldKind::string;
}

enum class Arity : std::uint8_t { one, fixed, sequence };

struct Field {
  std::string name;
  FieldKind kind = FieldKind::uint8;
  Arity arity = Arity::one;
  std::uint32_t count = 1;  // of a fixed array
  std::size_t type = 0;     // of a message: the place among the types
};

struct MessageType {
  std::string name;  // "geometry_msgs/Twist"
  std::vector<Field> fields;
};

struct MessageDefinition {
  std::vector<MessageType> types;  // the first is the message itself; none contains itself
};

// "geometry_msgs/Twist" of "geometry_msgs/msg/Twist".
std::string short_type_name(std::string_view name);

// The definition, or why messages of this type cannot be decoded.
tl::expected<MessageDefinition, std::string> parse_definition(std::string_view type, std::string_view text,
                                                              Dialect dialect);

}  // namespace wheelwright::import::ros
