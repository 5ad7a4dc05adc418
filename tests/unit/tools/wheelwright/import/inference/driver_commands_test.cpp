// Commands as drivers of robots take them: sticks, a velocity and a radius, the registers of a servo.
#include <cmath>
#include <numbers>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using std::numbers::pi;

ImportOutcome import_commands(const ForeignDrive& drive, const std::string& names,
                              const std::function<std::string(const ForeignRow&)>& commands,
                              const std::vector<std::string>& settings = seen_settings) {
  return import_text(foreign_text(drive, "t," + names + ",enc_left,enc_right",
                                  [&](const ForeignRow& row) {
                                    return number(row.t_s) + "," + commands(row) + "," + counts(row);
                                  }),
                     settings);
}

// -1 of the first is forward, 1 of the second turns left.
std::string stick(const ForeignRow& row) {
  return number(-row.linear() / 0.5) + "," + number(row.angular(ForeignDrive::base_m) / 3.0);
}

std::string velocity_and_radius(const ForeignRow& row) {
  const double turn = row.angular(ForeignDrive::base_m);
  const double forward_mm_s = 1000.0 * row.linear();
  if (std::abs(turn) < 1e-9) return std::to_string(std::lround(forward_mm_s)) + ",32768";
  if (std::abs(forward_mm_s) < 1e-9)
    return std::to_string(std::lround(1000.0 * std::abs(row.command_right))) + (turn > 0.0 ? ",1" : ",-1");
  return std::to_string(std::lround(forward_mm_s)) + "," + std::to_string(std::lround(forward_mm_s / turn));
}

double in_registers(double speed_m_s, double radius_m) {
  return std::round(speed_m_s / radius_m * 30.0 / pi / 0.229);
}

}  // namespace

TEST_CASE("A stick whose -1 is forward is turned round, by its names and by the wheels alone") {
  const auto drive = foreign_drive();
  for (const char* names : {"axis_linear,axis_angular", "joy_y,joy_x", "axes[1],axes[0]"}) {
    INFO(names);
    const auto outcome = import_commands(drive, names, stick);
    check_same(outcome, drive, 0.01);
    CHECK(outcome.found("is forward: the wheels count up with it"));
    CHECK_FALSE(outcome.understood.mapping.reference);
  }
  const auto tank = import_commands(drive, "left_stick_y,right_stick_y", [](const ForeignRow& row) {
    return number(-row.command_left / 0.5) + "," + number(-row.command_right / 0.5);
  });
  check_same(tank, drive, 0.01);
}

TEST_CASE("A stick without wheels beside it is doubted") {
  const auto outcome = import_text(foreign_text(foreign_drive(), "t,joy_y,joy_x,x,y,theta",
                                                [](const ForeignRow& row) {
                                                  return number(row.t_s) + "," + stick(row) + "," +
                                                         number(row.x) + "," + number(row.y) + "," +
                                                         number(row.theta);
                                                }),
                                   seen_settings);
  CHECK(outcome.doubts("which way a stick is forward"));
}

TEST_CASE("A velocity and a radius are the speeds of the wheels, with the radii that are none") {
  // Commands of whole millimetres per second: straight, arcs, and turns on the spot to either side.
  const auto drive =
      drive_by([](std::size_t k) { return std::array{0.0, 0.2, 0.1, -0.1, 0.1, -0.15}[k / 37 % 6]; },
               [](std::size_t k) { return std::array{0.0, 0.2, 0.2, 0.1, -0.1, -0.05}[k / 37 % 6]; });
  const auto outcome = import_commands(drive, "velocity,radius", velocity_and_radius);
  check_same(outcome, drive, 2e-3);
  CHECK(outcome.understood.mapping.command->by_radius);
  const auto by_zero = import_commands(drive, "velocity,radius", [](const ForeignRow& row) {
    const std::string text = velocity_and_radius(row);
    return text.ends_with(",32768") ? text.substr(0, text.find(',')) + ",0" : text;
  });
  check_same(by_zero, drive, 2e-3);
}

TEST_CASE("Speeds of a servo are in its own unit where the wheels show it, and asked for where they do not") {
  constexpr double radius_m = 0.033;
  const auto drive = foreign_drive();
  const auto commands = [&](const ForeignRow& row) {
    return number(in_registers(row.command_left, radius_m)) + "," +
           number(in_registers(row.command_right, radius_m));
  };
  auto settings = seen_settings;
  settings.emplace_back("wheels.wheel_radius_m=0.033");
  const auto outcome = import_commands(drive, "goal_velocity_left,goal_velocity_right", commands, settings);
  check_same(outcome, drive, 2e-3);
  CHECK(outcome.found("commands are in 0.229rpm"));
  const auto speeds = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"robot.wheel_base_m=0.3", "wheels.wheel_radius_m=0.033"};
    all.insert(all.end(), more.begin(), more.end());
    return import_text(
        foreign_text(drive,
                     "t,goal_velocity_left,goal_velocity_right,present_velocity_left,present_velocity_right",
                     [&](const ForeignRow& row) {
                       return number(row.t_s) + "," + commands(row) + "," + commands(row);
                     }),
        all);
  };
  const auto unknown = speeds({});
  REQUIRE_FALSE(unknown.conversion);
  CHECK_THAT(unknown.conversion.error(), ContainsSubstring("--set wheels.unit=0.229rpm"));
  CHECK(speeds({"command.unit=0.229rpm", "wheels.unit=0.229rpm"}).conversion);
}

TEST_CASE("Positions of wheels are counts where it is said how far one goes") {
  const auto drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,cmd_left,cmd_right,present_position_left,present_position_right",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + "," + number(row.command_left) + "," +
                                        number(row.command_right) + "," + counts(row);
                               }),
                  seen_settings);
  check_same(outcome, drive);
}
