// Poses by the names of their columns.
#include <array>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> base{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

std::string motion(const ForeignRow& row) {
  return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
         counts(row);
}

std::string pose(const ForeignRow& row) {
  return number(row.x) + "," + number(row.y) + "," + number(row.theta);
}

// What the robot makes of its counts.
std::string odometry(const ForeignRow& row) {
  return number(1.1 * row.x) + "," + number(1.1 * row.y) + "," + number(1.2 * row.theta);
}

}  // namespace

TEST_CASE("Of two poses in a table one is the reference, whole, and the other is named") {
  const ForeignDrive drive = foreign_drive();
  for (const auto& [names, x, y, theta] :
       {std::array{"odom_x,odom_y,odom_th,mocap_x,mocap_y,mocap_th", "mocap_x", "mocap_y", "mocap_th"},
        std::array{"x,y,theta,gt_x,gt_y,gt_theta", "gt_x", "gt_y", "gt_theta"},
        std::array{"x_odom,y_odom,yaw_odom,x_vicon,y_vicon,yaw_vicon", "x_vicon", "y_vicon", "yaw_vicon"}}) {
    INFO(names);
    const auto outcome = import_text(
        foreign_text(
            drive, std::string("t,cmd_left,cmd_right,enc_left,enc_right,") + names,
            [](const ForeignRow& row) { return motion(row) + "," + odometry(row) + "," + pose(row); }),
        base);
    const auto& reference = outcome.understood.mapping.reference;
    REQUIRE(reference);
    CHECK(reference->x->channel == x);
    CHECK(reference->y->channel == y);
    REQUIRE(reference->theta);
    CHECK(reference->theta->channel == theta);
  }
}

TEST_CASE("Beside a place, an angle in several languages is the heading, and a command that turns is none") {
  const ForeignDrive drive = foreign_drive();
  for (const char* name : {"phi", "angle", "rot", "rz", "bearing", "Winkel", "cap", "angulo"}) {
    INFO(name);
    const auto outcome =
        import_text(foreign_text(drive, std::string("t,cmd_left,cmd_right,enc_left,enc_right,x,y,") + name,
                                 [](const ForeignRow& row) { return motion(row) + "," + pose(row); }),
                    base);
    REQUIRE(outcome.understood.mapping.reference);
    REQUIRE(outcome.understood.mapping.reference->theta);
    CHECK(outcome.understood.mapping.reference->theta->channel == name);
  }
  const auto french = import_text(
      foreign_text(drive, "temps,vitesse,rotation,codeur_gauche,codeur_droit,x,y,cap",
                   [](const ForeignRow& row) {
                     return number(row.t_s) + "," + number(row.linear()) + "," +
                            number(row.angular(ForeignDrive::base_m)) + "," + counts(row) + "," + pose(row);
                   }),
      base);
  CHECK(french.understood.mapping.command->second->channel == "rotation");
  CHECK(french.understood.mapping.reference->theta->channel == "cap");
}

TEST_CASE("A unit that is said of commands holds, whatever the numbers look like") {
  const ForeignDrive drive = foreign_drive();
  const auto text = [&](const std::string& header) {
    return foreign_text(drive, header, [](const ForeignRow& row) {
      return number(row.t_s) + "," + number(1000.0 * row.command_left) + "," +
             number(1000.0 * row.command_right) + "," + counts(row);
    });
  };
  auto settings = base;
  check_same(import_text(text("t,v_l [mm/s],v_r [mm/s],enc_l,enc_r"), settings), drive);
  settings.emplace_back("command.unit=mm/s");
  check_same(import_text(text(""), settings), drive);
}
