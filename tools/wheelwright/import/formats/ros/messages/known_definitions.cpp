#include "tools/wheelwright/import/formats/ros/messages/known_definitions.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/ros/messages/definition.hpp"

namespace wheelwright::import::ros {
namespace {

struct KnownType {
  std::string_view name;
  std::string_view fields;  // with the names of packages, one field a line
};

// Facts from ros2/common_interfaces, ros2/geometry2, ros2/rcl_interfaces and
// iRobotEducation/irobot_create_msgs, unchanged from Foxy to Jazzy but for BatteryState, which has had a
// temperature all the time in ROS 2.
constexpr auto known_types = std::to_array<KnownType>({
    {"std_msgs/Bool", "bool data"},
    {"std_msgs/Byte", "byte data"},
    {"std_msgs/Char", "char data"},
    {"std_msgs/Empty", ""},
    {"std_msgs/String", "string data"},
    {"std_msgs/Int8", "int8 data"},
    {"std_msgs/Int16", "int16 data"},
    {"std_msgs/Int32", "int32 data"},
    {"std_msgs/Int64", "int64 data"},
    {"std_msgs/UInt8", "uint8 data"},
    {"std_msgs/UInt16", "uint16 data"},
    {"std_msgs/UInt32", "uint32 data"},
    {"std_msgs/UInt64", "uint64 data"},
    {"std_msgs/Float32", "float32 data"},
    {"std_msgs/Float64", "float64 data"},
    {"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride"},
    {"std_msgs/MultiArrayLayout", "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset"},
    {"std_msgs/Int8MultiArray", "std_msgs/MultiArrayLayout layout\nint8[] data"},
    {"std_msgs/Int16MultiArray", "std_msgs/MultiArrayLayout layout\nint16[] data"},
    {"std_msgs/Int32MultiArray", "std_msgs/MultiArrayLayout layout\nint32[] data"},
    {"std_msgs/Int64MultiArray", "std_msgs/MultiArrayLayout layout\nint64[] data"},
    {"std_msgs/UInt8MultiArray", "std_msgs/MultiArrayLayout layout\nuint8[] data"},
    {"std_msgs/UInt16MultiArray", "std_msgs/MultiArrayLayout layout\nuint16[] data"},
    {"std_msgs/UInt32MultiArray", "std_msgs/MultiArrayLayout layout\nuint32[] data"},
    {"std_msgs/UInt64MultiArray", "std_msgs/MultiArrayLayout layout\nuint64[] data"},
    {"std_msgs/Float32MultiArray", "std_msgs/MultiArrayLayout layout\nfloat32[] data"},
    {"std_msgs/Float64MultiArray", "std_msgs/MultiArrayLayout layout\nfloat64[] data"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id"},
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec"},
    {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec"},
    {"rosgraph_msgs/Clock", "builtin_interfaces/Time clock"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z"},
    {"geometry_msgs/PointStamped", "std_msgs/Header header\ngeometry_msgs/Point point"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z"},
    {"geometry_msgs/Vector3Stamped", "std_msgs/Header header\ngeometry_msgs/Vector3 vector"},
    {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w"},
    {"geometry_msgs/QuaternionStamped", "std_msgs/Header header\ngeometry_msgs/Quaternion quaternion"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation"},
    {"geometry_msgs/Pose2D", "float64 x\nfloat64 y\nfloat64 theta"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance"},
    {"geometry_msgs/PoseWithCovarianceStamped",
     "std_msgs/Header header\ngeometry_msgs/PoseWithCovariance pose"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular"},
    {"geometry_msgs/TwistStamped", "std_msgs/Header header\ngeometry_msgs/Twist twist"},
    {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance"},
    {"geometry_msgs/TwistWithCovarianceStamped",
     "std_msgs/Header header\ngeometry_msgs/TwistWithCovariance twist"},
    {"geometry_msgs/Accel", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular"},
    {"geometry_msgs/AccelStamped", "std_msgs/Header header\ngeometry_msgs/Accel accel"},
    {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
     "geometry_msgs/TwistWithCovariance twist"},
    {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms"},
    {"sensor_msgs/JointState",
     "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort"},
    {"sensor_msgs/Imu",
     "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
     "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
     "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance"},
    {"sensor_msgs/BatteryState",
     "std_msgs/Header header\nfloat32 voltage\nfloat32 temperature\nfloat32 current\nfloat32 charge\n"
     "float32 capacity\nfloat32 design_capacity\nfloat32 percentage\nuint8 power_supply_status\n"
     "uint8 power_supply_health\nuint8 power_supply_technology\nbool present\nfloat32[] cell_voltage\n"
     "float32[] cell_temperature\nstring location\nstring serial_number"},
    {"irobot_create_msgs/WheelTicks", "std_msgs/Header header\nint32 ticks_left\nint32 ticks_right"},
    {"irobot_create_msgs/WheelVels", "std_msgs/Header header\nfloat32 velocity_left\nfloat32 velocity_right"},
});

const KnownType* find_type(std::string_view name) {
  const auto* at = std::ranges::find(known_types, name, &KnownType::name);
  return at == known_types.end() ? nullptr : at;
}

// The types that the fields of one name.
std::vector<std::string_view> parts_of(std::string_view fields) {
  std::vector<std::string_view> parts;
  while (!fields.empty()) {
    const std::string_view type = fields.substr(0, fields.find_first_of("[ "));
    if (type.find('/') != std::string_view::npos) parts.push_back(type);
    fields.remove_prefix(std::min(fields.find('\n'), fields.size() - 1) + 1);
  }
  return parts;
}

bool has_fields(const KnownType& type, std::span<const std::string> names) {
  std::string_view fields = type.fields;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view line = fields.substr(0, fields.find('\n'));
    if (line.empty() || line.substr(line.rfind(' ') + 1) != names[i]) return false;
    fields.remove_prefix(std::min(line.size() + 1, fields.size()));
  }
  return fields.empty();
}

}  // namespace

std::string_view type_with_fields(std::span<const std::string> names) {
  if (names.size() < 2) return {};
  const auto* found =
      std::ranges::find_if(known_types, [names](const KnownType& type) { return has_fields(type, names); });
  return found == known_types.end() ? std::string_view() : found->name;
}

std::optional<std::string> known_definition(std::string_view type) {
  const KnownType* known = find_type(short_type_name(type));
  if (known == nullptr) return std::nullopt;
  std::string text(known->fields);
  std::vector<std::string_view> open = parts_of(known->fields);
  std::unordered_set<std::string_view> written;
  while (!open.empty()) {
    const KnownType* part = find_type(open.back());
    open.pop_back();
    if (part == nullptr || !written.insert(part->name).second) continue;
    text += "\n====\nMSG: " + std::string(part->name) + "\n" + std::string(part->fields);
    for (const std::string_view deeper : parts_of(part->fields)) open.push_back(deeper);
  }
  return text;
}

}  // namespace wheelwright::import::ros
