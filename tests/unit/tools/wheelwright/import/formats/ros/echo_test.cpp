// What rostopic echo and ros2 topic echo print, kept in a file.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using Names = std::vector<std::string>;

// "12,50000000" of 12.05 s.
std::string stamp(double t_s, const std::string& between = ",") {
  const double whole_s = std::floor(t_s + 1e-9);
  return std::to_string(std::lround(whole_s)) + between +
         std::to_string(std::lround(std::abs(t_s - whole_s) * 1e9));
}

std::string zeros(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += ",0.0";
  return text;
}

std::string odometry_row(const ForeignRow& row, double base_m) {
  return stamp(row.t_s) + ",odom,base_footprint," + number(row.x) + "," + number(row.y) + ",0.0,0.0,0.0," +
         number(std::sin(0.5 * row.theta)) + "," + number(std::cos(0.5 * row.theta)) + zeros(36) + "," +
         number(row.linear()) + ",0.0,0.0,0.0,0.0," + number(row.angular(base_m)) + zeros(36);
}

std::string joint_row(const ForeignRow& row) {
  constexpr double rad_per_count = 0.01;
  return stamp(row.t_s) + ",,wheel_left_joint,wheel_right_joint," +
         number(rad_per_count * static_cast<double>(row.counts_left)) + "," +
         number(rad_per_count * static_cast<double>(row.counts_right)) + ",0.0,0.0";
}

std::string twist_row(const ForeignRow& row) {
  return stamp(row.t_s) + ",base_link," + number(row.linear()) + ",0.0,0.0,0.0,0.0," +
         number(row.angular(ForeignDrive::base_m));
}

std::string joint_message(const ForeignRow& row) {
  constexpr double rad_per_count = 0.01;
  return "header: \n  seq: 7\n  stamp: \n    secs: " + stamp(row.t_s, "\n    nsecs: ") +
         "\n  frame_id: ''\nname: [wheel_left_joint, wheel_right_joint]\nposition:\n- " +
         number(rad_per_count * static_cast<double>(row.counts_left)) + "\n- " +
         number(rad_per_count * static_cast<double>(row.counts_right)) + "\nvelocity: []\neffort: []\n---";
}

std::string twist_message(const ForeignRow& row) {
  return "header:\n  stamp:\n    sec: " + stamp(row.t_s, "\n    nanosec: ") +
         "\n  frame_id: base_link\ntwist:\n  linear:\n    x: " + number(row.linear()) +
         "\n    y: 0.0\n    z: 0.0\n  angular:\n    x: 0.0\n    y: 0.0\n    z: " +
         number(row.angular(ForeignDrive::base_m)) + "\n---";
}

ImportOutcome import_topics(const std::string& commands, const std::string& joints) {
  const auto files = {file_of("cmd_vel.txt", commands), file_of("joint_states.txt", joints)};
  auto understood =
      import::understand({files, std::nullopt, import::GivenMapping("", {"robot.wheel_base_m=0.3"})});
  if (!understood) FAIL(understood.error());
  auto conversion = import::to_runs(*understood);
  return {std::move(*understood), std::move(conversion)};
}

}  // namespace

TEST_CASE("Rows of an odometry without names are recognised by their header, texts and quaternion") {
  const ForeignDrive drive = foreign_drive(100);
  const import::Recording recording =
      read_text(foreign_text(drive, "", [](const ForeignRow& row) { return odometry_row(row, 0.3); }));
  CHECK(recording.streams[0].type == "nav_msgs/Odometry");
  CHECK_THAT(recording.format, ContainsSubstring("nav_msgs/Odometry"));
  CHECK(values(recording.streams[0], "pose.pose.position.x")[99] == Approx(drive.rows[99].x).margin(1e-6));
  CHECK(values(recording.streams[0], "twist.twist.linear.x")[99] ==
        Approx(drive.rows[99].linear()).margin(1e-6));
}

TEST_CASE("Numbers that are no quaternion are no pose") {
  const ForeignDrive drive = foreign_drive(100);
  const import::Recording recording = read_text(foreign_text(drive, "", [](const ForeignRow& row) {
    return stamp(row.t_s) + ",base," + number(row.x) + ",1,2,3,4,5,6";
  }));
  CHECK(recording.streams[0].type.empty());
  CHECK(recording.streams[0].find("header.stamp.sec") != nullptr);
  CHECK(recording.streams[0].find("7") != nullptr);
}

TEST_CASE("Joints carry the names that stand in each row") {
  const import::Recording recording = read_text(foreign_text(foreign_drive(50), "", joint_row));
  CHECK(recording.streams[0].type == "sensor_msgs/JointState");
  CHECK(recording.streams[0].find("position[wheel_right_joint]") != nullptr);
  CHECK(recording.streams[0].find("velocity[wheel_left_joint]") != nullptr);
  CHECK(recording.streams[0].find("effort[wheel_left_joint]") == nullptr);
}

TEST_CASE("A table that begins with two whole numbers is no message") {
  const import::Recording recording = read_text("0,12,0.1,0.2\n1,13,0.2,0.3\n2,15,0.2,0.3\n3,15,0.4,0.5\n");
  CHECK(names(recording.streams[0]) == Names{"1", "2", "3", "4"});
}

TEST_CASE("Messages as YAML have the channels of a bag") {
  const import::Recording recording = read_text(foreign_text(foreign_drive(50), "", joint_message));
  CHECK_THAT(recording.format, ContainsSubstring("YAML"));
  CHECK(recording.streams[0].type == "sensor_msgs/JointState");
  CHECK(names(recording.streams[0]) ==
        Names{"header.seq", "header.stamp", "position[wheel_left_joint]", "position[wheel_right_joint]"});
  CHECK(values(recording.streams[0], "header.stamp")[3] == Approx(0.15));
}

TEST_CASE("A message that is cut short is left out and named") {
  const import::Recording recording =
      read_text("a: 1\nb: [1, 2]\n---\na: 2\nb: [3, 4]\n---\na: 3\nb: [5, \n");
  CHECK(values(recording.streams[0], "b[1]") == Values{2.0, 4.0});
  CHECK(has_remark(recording, "line 7: no message in YAML"));
}

TEST_CASE("Topics that ros2 topic echo --csv has printed make a drive") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome =
      import_topics(foreign_text(drive, "", twist_row), foreign_text(drive, "", joint_row));
  check_same(outcome, drive);
}

TEST_CASE("Topics that rostopic echo has printed make a drive") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome =
      import_topics(foreign_text(drive, "", twist_message), foreign_text(drive, "", joint_message));
  check_same(outcome, drive);
}
