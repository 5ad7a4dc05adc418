// Names that controllers and their authors give to what they want and what they measure.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> wheel_base{"robot.wheel_base_m=0.3"};

// Speeds of both wheels as measured, by the counts of a row and the one before, in m/s.
std::vector<WheelPair> measured_speeds(const ForeignDrive& drive) {
  std::vector<WheelPair> speeds{{}};
  for (std::size_t k = 1; k < drive.rows.size(); ++k) {
    const double m_s = ForeignDrive::metres_per_count / drive.period_s;
    speeds.push_back(
        {m_s * static_cast<double>(drive.rows[k].counts_left - drive.rows[k - 1].counts_left),
         m_s * static_cast<double>(drive.rows[k].counts_right - drive.rows[k - 1].counts_right)});
  }
  return speeds;
}

std::string joined(const std::vector<double>& values, const std::string& separator = ",") {
  std::string line;
  for (const double value : values) {
    if (!line.empty()) line += separator;
    line += number(value);
  }
  return line;
}

// Commands and measured speeds, each as `unit` of a m/s.
ImportOutcome import_speeds(const ForeignDrive& drive, const std::string& header, double unit,
                            const std::vector<std::string>& settings = wheel_base) {
  const auto speeds = measured_speeds(drive);
  std::size_t row_number = 0;
  return import_text(foreign_text(drive, header,
                                  [&](const ForeignRow& row) {
                                    const WheelPair& speed = speeds.at(row_number++);
                                    return joined({row.t_s, unit * row.command_left, unit * row.command_right,
                                                   unit * speed.left, unit * speed.right});
                                  }),
                     settings);
}

void check_commands(const ImportOutcome& outcome, const ForeignDrive& drive, double tolerance_m_s = 1e-3) {
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    INFO(k);
    REQUIRE(std::abs(log.samples[k].command_m_s.left - drive.rows[k].command_left) < tolerance_m_s);
    REQUIRE(std::abs(log.samples[k].command_m_s.right - drive.rows[k].command_right) < tolerance_m_s);
  }
}

// How far the left wheel went in all.
double left_way_m(const ImportOutcome& outcome) {
  const DriveLog& log = outcome.conversion->runs.front();
  return log.metres_per_tick->left *
         static_cast<double>(log.samples.back().ticks->left - log.samples.front().ticks->left);
}

double true_left_way_m(const ForeignDrive& drive) {
  return ForeignDrive::metres_per_count * static_cast<double>(drive.rows.back().counts_left);
}

}  // namespace

TEST_CASE("What a controller wants of a wheel is the command, and what it measures the wheel") {
  const auto drive = foreign_drive();
  for (const char* header :
       {"t,vl_ref,vr_ref,vl,vr", "t,v_l_soll,v_r_soll,v_l_ist,v_r_ist", "t,vL*,vR*,vL,vR",
        "t,tgtL,tgtR,spdL,spdR",
        "temps,vitesse_consigne_g,vitesse_consigne_d,vitesse_mesuree_g,vitesse_mesuree_d"}) {
    INFO(header);
    const auto outcome = import_speeds(drive, header, 1.0);
    check_commands(outcome, drive);
    CHECK_THAT(left_way_m(outcome), WithinRel(true_left_way_m(drive), 0.02));
  }
}

TEST_CASE("Columns that are stated as commands are no wheels") {
  const auto drive = foreign_drive();
  auto settings = wheel_base;
  settings.emplace_back("command.left=a_left");
  settings.emplace_back("command.right=a_right");
  for (const char* header : {"t,a_left,a_right,speed_left,speed_right", "t,speed_left,speed_right,v_l,v_r"}) {
    INFO(header);
    if (std::string_view(header).find("a_left") == std::string_view::npos) {
      settings[1] = "command.left=speed_left";
      settings[2] = "command.right=speed_right";
    }
    const auto outcome = import_speeds(drive, header, 1.0, settings);
    check_commands(outcome, drive);
    REQUIRE(outcome.understood.mapping.wheels);
    CHECK(outcome.understood.mapping.wheels->left.channel !=
          outcome.understood.mapping.command->first.channel);
    CHECK_THAT(left_way_m(outcome), WithinRel(true_left_way_m(drive), 0.02));
  }
}

TEST_CASE("The omega of a wheel is in rad/s, and takes the radius of the wheels") {
  const auto drive = foreign_drive();
  constexpr double radius_m = 0.035;
  auto settings = wheel_base;
  settings.emplace_back("wheels.wheel_radius_m=0.035");
  const auto outcome =
      import_speeds(drive, "t,omega_l_ref,omega_r_ref,omega_l,omega_r", 1.0 / radius_m, settings);
  check_commands(outcome, drive);
  CHECK_THAT(left_way_m(outcome), WithinRel(true_left_way_m(drive), 0.02));
}

TEST_CASE("Whole numbers of commands and speeds without a unit are mm/s, and doubted") {
  const auto drive = foreign_drive();
  const auto speeds = measured_speeds(drive);
  std::size_t row_number = 0;
  const auto outcome =
      import_text(foreign_text(drive, "ms,tgtL,tgtR,spdL,spdR",
                               [&](const ForeignRow& row) {
                                 const WheelPair& speed = speeds.at(row_number++);
                                 std::string line;
                                 for (const double value :
                                      {1e3 * row.t_s, 1e3 * row.command_left, 1e3 * row.command_right,
                                       1e3 * speed.left, 1e3 * speed.right}) {
                                   if (!line.empty()) line += ",";
                                   line += std::to_string(std::lround(value));
                                 }
                                 return line;
                               }),
                  wheel_base);
  check_commands(outcome, drive);
  CHECK(outcome.doubts("are taken for mm/s"));
}

TEST_CASE("Throttle and turn are mixed to two wheels") {
  const auto drive = foreign_drive();
  for (const char* header : {"t,throttle,turn,encL,encR", "t,joy_throttle,joy_turn,encL,encR"}) {
    INFO(header);
    auto settings = wheel_base;
    settings.emplace_back("wheels.metres_per_count=0.0005");
    const auto outcome = import_text(
        foreign_text(drive, header,
                     [](const ForeignRow& row) {
                       std::string line = joined(
                           {row.t_s, row.linear() / 0.6, 0.5 * (row.command_right - row.command_left) / 0.6});
                       line += ",";
                       return line + counts(row);
                     }),
        settings);
    check_same(outcome, drive, 0.006);
  }
}

TEST_CASE("esq and dir are left and right, in Portuguese") {
  const auto drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "tempo,ref_esq,ref_dir,enc_esq,enc_dir",
                               [](const ForeignRow& row) {
                                 std::string line = joined({row.t_s, row.command_left, row.command_right});
                                 line += ",";
                                 return line + counts(row);
                               }),
                  wheel_base);
  check_same(outcome, drive);
}

TEST_CASE("A motor that is mounted the other way round is reversed where that is stated") {
  const auto drive = foreign_drive();
  auto settings = wheel_base;
  settings.emplace_back("wheels.metres_per_count=0.0005");
  const auto text = foreign_text(drive, "t,servo_l,servo_r,enc_l,enc_r", [](const ForeignRow& row) {
    std::string line = number(row.t_s);
    for (const double value : {90.0 + 250.0 * row.command_left, 90.0 - 250.0 * row.command_right}) {
      line += ",";
      line += std::to_string(std::lround(value));
    }
    line += ",";
    return line + counts(row);
  });
  CHECK(import_text(text, settings).doubts("if the motor is: --set command.reversed=right"));
  settings.emplace_back("command.reversed=right");
  check_same(import_text(text, settings), drive, 0.01);
}

TEST_CASE("A yaw alone that turns against the wheels is clockwise") {
  const auto drive = foreign_drive();
  const auto outcome = import_text(
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,yaw",
                   [](const ForeignRow& row) {
                     std::string line = joined({row.t_s, row.command_left, row.command_right});
                     line += ",";
                     line += counts(row);
                     line += ",";
                     return line +
                            number(std::fmod(3600.0 + 90.0 - row.theta * 180.0 / 3.14159265358979, 360.0));
                   }),
      {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  REQUIRE(outcome.conversion);
  CHECK(outcome.found("headings are clockwise: they turn against the wheels"));
  const auto& samples = outcome.conversion->runs.front().samples;
  CHECK_THAT(wrap_angle(*samples.back().reference_theta_rad - *samples.front().reference_theta_rad -
                        drive.rows.back().theta),
             WithinAbs(0.0, 0.01));
}

TEST_CASE("The kind of wheels whose columns alone are stated is that of their names") {
  const auto drive = foreign_drive();
  auto settings = wheel_base;
  settings.emplace_back("wheels.left=v_l");
  settings.emplace_back("wheels.right=v_r");
  const auto outcome = import_speeds(drive, "t,cmd_left,cmd_right,v_l,v_r", 1.0, settings);
  REQUIRE(outcome.conversion);
  CHECK(outcome.understood.mapping.wheels->kind == import::WheelKind::speed);
  CHECK_THAT(left_way_m(outcome), WithinRel(true_left_way_m(drive), 0.02));
}
