// Several bodies that a tracker follows, of which one is the robot.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

std::string log_of(const ForeignDrive& drive) {
  return foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right", [](const ForeignRow& row) {
    return number(row.t_s) + field(row.command_left) + field(row.command_right) + "," + counts(row);
  });
}

import::Understood understand_bodies(const ForeignDrive& drive, const std::string& poses){
    auto understood = import::understand({
        {file_of("drive.csv", log_of(drive))},
        file_of("mocap.csv", poses),
        import::GivenMapping("", {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"})});
if (!understood) FAIL(understood.error());
return std::move(*understood);
}  // namespace

// Another robot that drives elsewhere, and a tag on the wall.
std::string bodies(const ForeignDrive& drive, const std::string& name,
                   const std::array<std::string, 3>& ids) {
  const ForeignDrive other = joystick_drive();
  std::string text = "t," + name + ",x,y,theta\n";
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    const auto line = [&](const std::string& id, double x, double y, double theta) {
      text += number(100.0 + drive.rows[k].t_s) + "," + id + field(x) + field(y) + field(theta) + "\n";
    };
    line(ids[0], 3.0, 2.0, 1.0);
    line(ids[1], other.rows[k].x, 5.0 + other.rows[k].y, other.rows[k].theta);
    line(ids[2], drive.rows[k].x, drive.rows[k].y, drive.rows[k].theta);
  }
  return text;
}

}  // namespace

TEST_CASE("Of several bodies the one that moves as the robot does is its reference") {
  const ForeignDrive drive = foreign_drive();
  for (const auto& [name, ids] : {std::pair{"name", std::array<std::string, 3>{"wall", "alice", "bob"}},
                                  std::pair{"tag_id", std::array<std::string, 3>{"3", "9", "7"}}}) {
    CAPTURE(name);
    const auto understood = understand_bodies(drive, bodies(drive, name, ids));
    CHECK(has_words(understood.inference.findings, "moves as the robot does"));
    CHECK_THAT(*understood.mapping.reference->shift_s, WithinAbs(-100.0, 0.3));
    const auto runs = import::to_runs(understood);
    REQUIRE(runs);
    const DriveSample& sample = runs->runs.front().samples[600];
    REQUIRE(sample.reference_x_m);
    CHECK_THAT(*sample.reference_x_m, WithinAbs(drive.rows[600].x, 0.06));
  }
}

TEST_CASE(
    "Numbers of robots whose rows take turns part them, and a number that goes with one thing does not") {
  const ForeignDrive drive = foreign_drive();
  const ForeignDrive other = joystick_drive();
  std::string swarm = "t,robot,cmd_left,cmd_right,enc_left,enc_right\n";
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    for (const auto& [id, row] : {std::pair{1, drive.rows[k]}, std::pair{2, other.rows[k]}})
      swarm += number(row.t_s) + "," + std::to_string(id) + field(row.command_left) +
               field(row.command_right) + "," + counts(row) + "\n";
  }
  const auto outcome = import_text(swarm, seen_settings);
  check_same(outcome, drive);
  CHECK(outcome.found("there are also robot 2"));
  std::size_t k = 0;
  const auto one =
      import_seen(drive, "track_id", [&k](const ForeignRow&) { return "," + std::to_string(k++ % 3); });
  check_same(one, drive);
}

TEST_CASE("Targets in whole numbers that change all the time part no rows, though what follows them jumps") {
  const ForeignDrive drive = joystick_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,left_target,right_target,encL,encR,left_pwm",
                               [](const ForeignRow& row) {
                                 const double target = std::round(100.0 * row.command_left);
                                 return number(row.t_s) + "," + std::to_string(std::lround(target)) + "," +
                                        std::to_string(std::lround(100.0 * row.command_right)) + "," +
                                        counts(row) + field(17.0 * target);
                               }),
                  {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005", "command.unit=cm/s"});
  REQUIRE(outcome.conversion);
  CHECK(outcome.conversion->runs.front().samples.size() == drive.rows.size());
  CHECK(outcome.understood.recordings.front().streams.size() == 1);
}
