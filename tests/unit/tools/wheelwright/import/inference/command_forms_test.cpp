// Commands as throttle and steering or as a pulse width with a bit of direction, and gyros in raw numbers.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> known{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

std::string pulse_widths(const ForeignDrive& drive, const std::string& names, bool forward_is_one) {
  return foreign_text(drive, "t," + names + ",encL,encR", [&](const ForeignRow& row) {
    const auto width = [](double command) { return std::to_string(std::lround(1000.0 * std::abs(command))); };
    const auto bit = [&](double command) { return (command >= 0.0) == forward_is_one ? "1" : "0"; };
    return number(row.t_s) + "," + width(row.command_left) + "," + bit(row.command_left) + "," +
           width(row.command_right) + "," + bit(row.command_right) + "," + counts(row);
  });
}

// The turn rate of the wheels at a row.
double turn_rate(const ForeignDrive& drive, std::size_t k) {
  if (k == 0) return 0.0;
  return (drive.rows[k].theta - drive.rows[k - 1].theta) / drive.period_s;
}

ImportOutcome with_gyro(const ForeignDrive& drive, const std::string& name, double per_rad_s, double offset,
                        const std::vector<std::string>& settings = known) {
  std::size_t k = 0;
  return import_text(
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right," + name,
                   [&](const ForeignRow& row) {
                     const double gyro = per_rad_s * turn_rate(drive, k++) + offset;
                     return number(row.t_s) + "," + number(row.command_left) + "," +
                            number(row.command_right) + "," + counts(row) + "," +
                            (per_rad_s > 100.0 ? std::to_string(std::lround(gyro)) : number(gyro));
                   }),
      settings);
}

}  // namespace

TEST_CASE("Throttle and steering are mixed to the wheels with the sign that the wheels show") {
  const auto drive = foreign_drive();
  for (const double sign : {1.0, -1.0}) {
    const auto text = foreign_text(drive, "t,throttle,steering,encL,encR", [&](const ForeignRow& row) {
      const double steering = 0.5 * (row.command_right - row.command_left);
      return number(row.t_s) + "," + number(2.0 * row.linear()) + "," + number(sign * 2.0 * steering) + "," +
             counts(row);
    });
    INFO(sign);
    const auto outcome = import_text(text, known);
    check_same(outcome, drive, 0.006);
    CHECK(outcome.found("steering is mixed as left = throttle"));
    CHECK(outcome.understood.mapping.command->steering_gain * sign > 0.9);
  }
}

TEST_CASE("How steering is mixed is doubted where no wheels show it") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,throttle,steering,x,y", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.linear()) + ",0.1," + number(row.x) + "," + number(row.y);
  });
  CHECK(import_text(text, {"robot.wheel_base_m=0.3"}).doubts("--set command.steering_gain=-1"));
}

TEST_CASE("A pulse width has the sign of the bit beside it, whichever value of it is forward") {
  const auto drive = foreign_drive();
  for (const char* names : {"pwmL,dirL,pwmR,dirR", "pwm1,dir1,pwm2,dir2"}) {
    for (const bool forward_is_one : {true, false}) {
      INFO(names << (forward_is_one ? ", 1" : ", 0"));
      const auto outcome = import_text(pulse_widths(drive, names, forward_is_one), known);
      check_same(outcome, drive, 0.006);
      CHECK(outcome.understood.inference.doubts.empty());
      CHECK(outcome.found("forward is the direction bit 0") == !forward_is_one);
    }
  }
}

TEST_CASE("The unit of a gyro that the file does not say is found by the wheels") {
  const auto drive = foreign_drive();
  constexpr double degrees = 57.29577951;
  const auto raw = with_gyro(drive, "gyro_z", 131.0 * degrees, -212.0);
  CHECK(raw.found("131 for a deg/s (MPU-6050"));
  REQUIRE(raw.conversion);
  const auto& sample = raw.conversion->runs.front().samples[700];
  CHECK_THAT(*sample.gyro_z_rad_s + 212.0 / 131.0 / degrees, WithinAbs(turn_rate(drive, 700), 1e-3));
  const auto other = with_gyro(drive, "gz", 90.0 * degrees, 0.0);
  CHECK_THAT(*other.understood.mapping.gyro->lsb_per_deg_s, WithinRel(90.0, 0.03));
  CHECK(other.found("raw numbers"));
  const auto in_degrees = with_gyro(drive, "gyro_z", degrees, 0.3);
  CHECK(in_degrees.understood.mapping.gyro->unit == "deg/s");
  CHECK(in_degrees.found("the gyro is in deg/s"));
  const auto in_radians = with_gyro(drive, "gyro_z", 1.0, 0.0);
  CHECK(in_radians.understood.mapping.gyro->unit == "rad/s");
  CHECK(in_radians.understood.inference.doubts.empty());
}

TEST_CASE("A gyro is doubted where its numbers cannot be what its name says, or nothing shows their unit") {
  const auto drive = foreign_drive();
  CHECK(with_gyro(drive, "gyro_z [rad/s]", 131.0 * 57.3, 0.0).doubts("the gyro turns"));
  CHECK(with_gyro(drive, "gyro_z", -57.3, 0.0).doubts("against the wheels"));
  CHECK(
      with_gyro(drive, "gyro_z", 7500.0, 0.0, {"wheels.metres_per_count=0.0005"}).doubts("--set gyro.unit"));
  const auto said =
      with_gyro(drive, "gyro_z", 131.0 * 57.29578, 0.0, {known[0], known[1], "gyro.lsb_per_deg_s=131"});
  CHECK(said.understood.mapping.gyro->unit == "LSB");
  REQUIRE(said.conversion);
  CHECK_THAT(*said.conversion->runs.front().samples[700].gyro_z_rad_s,
             WithinAbs(turn_rate(drive, 700), 1e-3));
}

TEST_CASE("A direction in words is the sign of the pulse width beside it") {
  const auto drive = foreign_drive();
  struct Words {
    const char* names;
    const char* forward;
    const char* backward;
    const char* standing;
  };
  for (const Words& words :
       {Words{"pwmL,dirL,pwmR,dirR", "fwd", "rev", "stop"},
        {"pwm1,dir1,pwm2,dir2", "F", "B", "F"},
        {"left_pwm,left_direction,right_pwm,right_direction", "Forward", "Backward", "Stop"}}) {
    const auto text =
        foreign_text(drive, "t," + std::string(words.names) + ",encL,encR", [&](const ForeignRow& row) {
          const auto width = [](double command) {
            return std::to_string(std::lround(1000.0 * std::abs(command)));
          };
          const auto word = [&](double command) {
            return std::string(command > 0.0   ? words.forward
                               : command < 0.0 ? words.backward
                                               : words.standing);
          };
          return number(row.t_s) + "," + width(row.command_left) + "," + word(row.command_left) + "," +
                 width(row.command_right) + "," + word(row.command_right) + "," + counts(row);
        });
    INFO(words.names);
    const auto outcome = import_text(text, known);
    check_same(outcome, drive, 0.006);
    CHECK(outcome.understood.inference.doubts.empty());
  }
}

TEST_CASE("A target speed without a sign takes the direction beside it") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(
      drive, "t,target_left,dir_left,target_right,dir_right,encL,encR", [&](const ForeignRow& row) {
        const auto word = [](double command) { return std::string(command < 0.0 ? "reverse" : "forward"); };
        return number(row.t_s) + "," + number(std::abs(row.command_left)) + "," + word(row.command_left) +
               "," + number(std::abs(row.command_right)) + "," + word(row.command_right) + "," + counts(row);
      });
  check_same(import_text(text, known), drive, 0.006);
}

TEST_CASE("The full scale of throttle and steering is found though the speed that it leads to is given") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,throttle,steering", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + number(100.0 * row.linear()) + "," +
           number(50.0 * (row.command_right - row.command_left));
  });
  const auto outcome = import_text(text, {"robot.wheel_base_m=0.3", "command.full_scale_m_s=1"});
  CHECK(outcome.understood.mapping.command->full_scale == 100.0);
}
