// Topics with times of their own, however a file puts them together.
#include <random>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::string given_base = "robot.wheel_base_m=0.3";
const std::string given_scale = "wheels.metres_per_count=0.0005";

std::string time_of(double t_s) {
  return std::to_string(t_s);
}

std::string plain_log(const ForeignDrive& drive) {
  return foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
           counts(row);
  });
}

}  // namespace

TEST_CASE("Rows of one topic each are joined at the counts, and no count is missed between them") {
  const ForeignDrive drive = foreign_drive();
  std::string text =
      "__time,/cmd_vel/left,/cmd_vel/right,/encoder/left,/encoder/right,/mocap/x,/mocap/y,/mocap/yaw\n";
  for (const auto& row : drive.rows) {
    text += time_of(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + ",,,,,\n";
    text += time_of(row.t_s + 0.001) + ",,," + counts(row) + ",,,\n";
    text += time_of(row.t_s + 0.002) + ",,,,," + number(row.x) + "," + number(row.y) + "," +
            number(row.theta) + "\n";
  }
  const auto outcome = import_text(text, {given_base, given_scale});
  check_same(outcome, drive);
  CHECK_FALSE(outcome.remarks("no counts"));
  const DriveSample& sample = outcome.conversion->runs.front().samples[700];
  REQUIRE(sample.reference_x_m);
  CHECK_THAT(*sample.reference_x_m, WithinAbs(drive.rows[700].x, 1e-3));
}

TEST_CASE("Counts that a table lacks now and then are lost, and their rows stay") {
  const ForeignDrive drive = foreign_drive();
  std::size_t k = 0;
  const auto text =
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right", [&k](const ForeignRow& row) {
        return time_of(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               (++k % 10 == 0 ? "," : counts(row));
      });
  const auto outcome = import_text(text, {given_base, given_scale});
  REQUIRE(outcome.conversion);
  CHECK(outcome.conversion->runs.front().samples.size() > drive.rows.size() - 2);
}

TEST_CASE("Lines of a key, a time and numbers without names are joined and told by how they move") {
  const ForeignDrive drive = foreign_drive();
  std::string text;
  std::size_t k = 0;
  for (const auto& row : drive.rows) {
    if (k++ % 3 == 0)
      text +=
          "CMD " + time_of(row.t_s) + " " + number(row.command_left) + " " + number(row.command_right) + "\n";
    text += "ENC " + time_of(row.t_s) + " " + std::to_string(row.counts_left) + " " +
            std::to_string(row.counts_right) + "\n";
  }
  const auto outcome = import_text(text, {given_base, given_scale});
  REQUIRE(outcome.understood.mapping.command);
  REQUIRE(outcome.understood.mapping.wheels);
  CHECK(outcome.understood.mapping.command->first.text() == "CMD:2");
  CHECK(outcome.understood.mapping.command->second->text() == "CMD:3");
  CHECK(outcome.understood.mapping.wheels->left.text() == "ENC:2");
  CHECK(outcome.understood.mapping.wheels->right->text() == "ENC:3");
  REQUIRE(outcome.conversion);
  CHECK(outcome.conversion->runs.front().samples.size() == drive.rows.size());
}

TEST_CASE("A steady command that ends while the robot drives is said, one that ends at rest is not") {
  ForeignDrive drive = foreign_drive();
  const auto import_until = [&](std::size_t last_row) {
    std::size_t k = 0;
    return import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right",
                                    [&](const ForeignRow& row) {
                                      const bool is_said = k++ < last_row;
                                      return time_of(row.t_s) + "," +
                                             (is_said
                                                  ? number(row.command_left) + "," + number(row.command_right)
                                                  : std::string(",")) +
                                             "," + counts(row);
                                    }),
                       {given_base, given_scale});
  };
  CHECK(import_until(800).remarks("no command for 20.0 s"));
  CHECK_FALSE(import_until(drive.rows.size()).remarks("no command"));
  for (std::size_t k = 790; k < drive.rows.size(); ++k)
    drive.rows[k].command_left = drive.rows[k].command_right = 0.0;
  CHECK_FALSE(import_until(800).remarks("no command"));
}

TEST_CASE("Counts since the row before are found by the distance of a count, whatever their name") {
  const ForeignDrive drive = foreign_drive();
  for (const char* names : {"a,b", "dticks_left,dticks_right"}) {
    INFO(names);
    ForeignRow before = drive.rows.front();
    const auto text =
        foreign_text(drive, std::string("t,cmd_left,cmd_right,") + names, [&before](const ForeignRow& row) {
          std::string line = time_of(row.t_s) + "," + number(row.command_left) + "," +
                             number(row.command_right) + "," +
                             std::to_string(row.counts_left - before.counts_left) + "," +
                             std::to_string(row.counts_right - before.counts_right);
          before = row;
          return line;
        });
    const auto outcome = import_text(text, {given_base, given_scale});
    check_same(outcome, drive);
    CHECK(outcome.understood.mapping.wheels->per_row);
  }
}

TEST_CASE("A motor that is mounted the other way round is found by the places of the robot") {
  const ForeignDrive drive = foreign_drive();
  const auto mirrored = [&](bool has_heading) {
    return import_text(
        foreign_text(
            drive, std::string("t,cmd_left,cmd_right,enc_left,enc_right,x,y") + (has_heading ? ",theta" : ""),
            [&](const ForeignRow& row) {
              return time_of(row.t_s) + "," + number(row.command_left) + "," + number(-row.command_right) +
                     "," + std::to_string(row.counts_left) + "," + std::to_string(-row.counts_right) + "," +
                     number(row.x) + "," + number(row.y) + (has_heading ? "," + number(row.theta) : "");
            }),
        {given_base, given_scale});
  };
  const auto outcome = mirrored(true);
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.command->right_reversed);
  CHECK(outcome.understood.mapping.wheels->right_reversed);
  CHECK(outcome.found("right motor is mounted the other way round"));
  check_same(mirrored(false), drive);
}

TEST_CASE("A reference that scatters by centimetres still shows how its clock is shifted") {
  const ForeignDrive drive = foreign_drive();
  std::mt19937 random(7);
  std::normal_distribution<double> scatter_m(0.0, 0.02);
  std::string tum;
  for (std::size_t k = 0; k < drive.rows.size(); k += 2) {
    const auto& row = drive.rows[k];
    tum += std::to_string(1.7e9 + 12.3 + row.t_s) + " " + number(row.x + scatter_m(random)) + " " +
           number(row.y + scatter_m(random)) + " 0 0 0 " + number(std::sin(0.5 * row.theta)) + " " +
           number(std::cos(0.5 * row.theta)) + "\n";
  }
  const auto understood = import::understand({{file_of("drive.csv", plain_log(drive))},
                                              file_of("mocap.txt", tum),
                                              import::GivenMapping("", {given_base, given_scale})});
  REQUIRE(understood);
  CHECK_THAT(*understood->mapping.reference->shift_s, WithinAbs(-1.7e9 - 12.3, 0.15));
}

TEST_CASE("A file of Vicon says how many frames a second has, and its RX to RW are a quaternion") {
  const ForeignDrive drive = foreign_drive();
  std::string vicon = "Objects\n20\n,,robot:robot,,,,,,\nFrame,Sub Frame,RX,RY,RZ,RW,TX,TY,TZ\n";
  int frame = 0;
  for (const auto& row : drive.rows) {
    vicon += std::to_string(++frame) + ",0,0,0," + number(std::sin(0.5 * row.theta)) + "," +
             number(std::cos(0.5 * row.theta)) + "," + number(1e3 * row.x) + "," + number(1e3 * row.y) +
             ",112.3\n";
  }
  const auto understood = import::understand({{file_of("drive.csv", plain_log(drive))},
                                              file_of("vicon.csv", vicon),
                                              import::GivenMapping("", {given_base, given_scale})});
  REQUIRE(understood);
  CHECK(understood->mapping.reference->unit == "mm");
  CHECK_FALSE(understood->mapping.time.period_s);
  const auto conversion = import::to_runs(*understood);
  REQUIRE(conversion);
  const DriveSample& sample = conversion->runs.front().samples[700];
  REQUIRE(sample.reference_pose());
  CHECK_THAT(sample.reference_pose()->x_m, WithinAbs(drive.rows[700].x, 0.01));
  CHECK_THAT(std::remainder(sample.reference_pose()->theta_rad - drive.rows[700].theta, 6.283185307),
             WithinAbs(0.0, 0.03));
}

TEST_CASE("Rows of a name and a value are wheels and commands by the name") {
  const ForeignDrive drive = foreign_drive();
  std::string text = "time,signal,value\n";
  for (const auto& row : drive.rows) {
    const std::string t = time_of(row.t_s);
    text += t + ",cmd_left," + number(row.command_left) + "\n" + t + ",cmd_right," +
            number(row.command_right) + "\n";
    text += t + ",enc_left," + std::to_string(row.counts_left) + "\n" + t + ",enc_right," +
            std::to_string(row.counts_right) + "\n";
  }
  check_same(import_text(text, {given_base, given_scale}), drive);
}

TEST_CASE("A state that changes at every row parts no table, two robots that take turns do") {
  const ForeignDrive drive = foreign_drive();
  std::size_t k = 0;
  const auto states =
      foreign_text(drive, "state,t,cmd_left,cmd_right,enc_left,enc_right", [&k](const ForeignRow& row) {
        return std::string(++k % 3 == 0 ? "IDLE," : "DRIVING,") + time_of(row.t_s) + "," +
               number(row.command_left) + "," + number(row.command_right) + "," + counts(row);
      });
  check_same(import_text(states, {given_base, given_scale}), drive);

  std::string robots = "robot,t,cmd_left,cmd_right,enc_left,enc_right\n";
  for (const auto& row : drive.rows) {
    const std::string rest =
        std::string(",") + number(row.command_left) + "," + number(row.command_right) + ",";
    robots += std::string("one,") + time_of(row.t_s) + rest + counts(row) + "\n";
    robots += std::string("two,") + time_of(row.t_s + 0.02) + rest +
              std::to_string(row.counts_left + 90'000) + "," + std::to_string(row.counts_right - 90'000) +
              "\n";
  }
  CHECK(import_text(robots, {given_base, given_scale}).found("there are also"));
}

TEST_CASE("A shift of the clock by which no pose falls into the drive is refused") {
  const ForeignDrive drive = foreign_drive();
  const auto reference = foreign_text(drive, "t,x,y,theta", [&](const ForeignRow& row) {
    return number(row.t_s + 5000.0) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta);
  });
  const auto understood =
      import::understand({{file_of("drive.csv", plain_log(drive))},
                          file_of("poses.csv", reference),
                          import::GivenMapping("", {given_base, given_scale, "reference.shift_s=0"})});
  REQUIRE(understood);
  const auto conversion = import::to_runs(*understood);
  REQUIRE_FALSE(conversion);
  CHECK_THAT(conversion.error(), ContainsSubstring("no pose of the reference falls into the drive"));
}

TEST_CASE("Wheels that a person states are an angle where they hold parts of one and their radius is known") {
  const ForeignDrive drive = foreign_drive();
  const auto text = foreign_text(drive, "t,cmd_left,cmd_right,field0,field1", [](const ForeignRow& row) {
    return time_of(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
           number(0.01 * static_cast<double>(row.counts_left)) + "," +
           number(0.01 * static_cast<double>(row.counts_right));
  });
  check_same(import_text(text, {given_base, "wheels.wheel_radius_m=0.05", "wheels.left=field0",
                                "wheels.right=field1"}),
             drive, 1e-3, 1e-3);
}
