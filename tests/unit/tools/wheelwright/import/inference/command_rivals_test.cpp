// Of several topics of commands, the one that the robot followed.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/import/inference/infer_mapping.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::Recording;
using import::Stream;

namespace {

Stream topic_of(const std::string& name, const std::string& type, const std::vector<std::string>& channels,
                const ForeignDrive& drive,
                const std::function<std::vector<double>(const ForeignRow&)>& values) {
  Stream stream;
  stream.name = name;
  stream.type = type;
  stream.rows = drive.rows.size();
  for (const std::string& channel : channels) stream.channels.push_back({channel, "", {}});
  for (const auto& row : drive.rows) {
    stream.received_s.push_back(1.7e9 + row.t_s);
    const auto fields = values(row);
    for (std::size_t k = 0; k < fields.size(); ++k) stream.channels[k].values.push_back(fields[k]);
  }
  return stream;
}

Stream twist(const std::string& name, const ForeignDrive& drive, double share) {
  return topic_of(name, "geometry_msgs/Twist", {"linear.x", "angular.z"}, drive,
                  [share](const ForeignRow& row) {
                    return std::vector{share * row.linear(), share * row.angular(ForeignDrive::base_m)};
                  });
}

// Half of the time somebody steers by hand.
Stream partly(const std::string& name, const ForeignDrive& drive) {
  return topic_of(name, "geometry_msgs/Twist", {"linear.x", "angular.z"}, drive, [](const ForeignRow& row) {
    const double share = row.t_s < 30.0 ? 1.0 : 0.0;
    return std::vector{share * row.linear(), share * row.angular(ForeignDrive::base_m)};
  });
}

Recording bag(const ForeignDrive& drive, std::vector<Stream> commands) {
  Recording recording;
  recording.name = "drive.mcap";
  recording.streams = std::move(commands);
  recording.streams.push_back(topic_of("/joint_states", "sensor_msgs/JointState",
                                       {"position[wheel_left_joint]", "position[wheel_right_joint]"}, drive,
                                       [](const ForeignRow& row) {
                                         return std::vector{0.01 * static_cast<double>(row.counts_left),
                                                            0.01 * static_cast<double>(row.counts_right)};
                                       }));
  return recording;
}

import::Inference infer(const Recording& recording, const std::vector<std::string>& settings){
    return import::infer_mapping({&recording, 1}, import::GivenMapping("", settings));
}  // namespace

std::string linear_of(const import::Inference& inference) {
  const auto at = std::ranges::find(inference.entries, "command.linear", &import::MappingEntry::key);
  return at == inference.entries.end() ? "" : at->value;
}

}  // namespace

TEST_CASE("The commands are those that explain the wheels, not those whose topic comes first") {
  const ForeignDrive drive = foreign_drive();
  const std::vector<std::string> robot{"robot.wheel_base_m=0.3", "wheels.wheel_radius_m=0.05"};
  const Recording recording = bag(drive, {partly("/cmd_vel_nav", drive), twist("/cmd_vel_teleop", drive, 0.0),
                                          twist("/cmd_vel", drive, 1.0)});
  const import::Inference inference = infer(recording, robot);
  CHECK(linear_of(inference) == "/cmd_vel:linear.x");
  CHECK(has_words(inference.findings, "the commands are /cmd_vel:linear.x"));
  CHECK_FALSE(has_words(inference.findings, "/cmd_vel_nav:linear.x was taken"));

  const import::Inference given = infer(
      recording,
      {robot[0], robot[1], "command.linear=/cmd_vel_nav:linear.x", "command.angular=/cmd_vel_nav:angular.z"});
  CHECK(linear_of(given) == "/cmd_vel_nav:linear.x");
}

TEST_CASE("Of commands that say the same the first is taken, and the others are named") {
  const ForeignDrive drive = foreign_drive();
  const import::Inference inference =
      infer(bag(drive, {twist("/cmd_vel", drive, 1.0), twist("/cmd_vel_out", drive, 1.0)}),
            {"robot.wheel_base_m=0.3", "wheels.wheel_radius_m=0.05"});
  CHECK(linear_of(inference) == "/cmd_vel:linear.x");
  CHECK(has_words(inference.findings, "there are also /cmd_vel_out:linear.x"));
}

TEST_CASE("Topics of one value each are the two sides by the names of the topics") {
  const ForeignDrive drive = foreign_drive();
  Recording recording;
  recording.name = "drive.bag";
  const auto value = [&](const std::string& name, const std::string& type,
                         const std::function<double(const ForeignRow&)>& of) {
    recording.streams.push_back(
        topic_of(name, type, {"data"}, drive, [&of](const ForeignRow& row) { return std::vector{of(row)}; }));
  };
  value("/wheel_left_controller/command", "std_msgs/Float64",
        [](const ForeignRow& row) { return row.command_left; });
  value("/wheel_right_controller/command", "std_msgs/Float64",
        [](const ForeignRow& row) { return row.command_right; });
  value("/lwheel", "std_msgs/Int32",
        [](const ForeignRow& row) { return static_cast<double>(row.counts_left); });
  value("/rwheel", "std_msgs/Int32",
        [](const ForeignRow& row) { return static_cast<double>(row.counts_right); });
  const import::Inference inference =
      infer(recording, {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  const auto entry = [&](const std::string& key) {
    const auto at = std::ranges::find(inference.entries, key, &import::MappingEntry::key);
    return at == inference.entries.end() ? std::string() : at->value;
  };
  CHECK(entry("command.left") == "/wheel_left_controller/command:data");
  CHECK(entry("command.right") == "/wheel_right_controller/command:data");
  CHECK(entry("wheels.left") == "/lwheel:data");
  CHECK(entry("wheels.right") == "/rwheel:data");
  CHECK(entry("wheels.kind") == "counts");

  recording.streams[2].name = "/left_wheel_speed";
  recording.streams[3].name = "/right_wheel_speed";
  const import::Inference speeds =
      infer(recording, {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  const auto kind = std::ranges::find(speeds.entries, "wheels.kind", &import::MappingEntry::key);
  CHECK(kind->value == "speed");
}
