#include "tools/wheelwright/import/columns/column_names.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::import;

namespace {

NameMeaning meaning(const std::string& channel, const std::string& stream = "",
                    const std::string& unit = "") {
  Stream of;
  of.name = stream;
  Channel named;
  named.name = channel;
  named.unit = unit;
  return meaning_of(of, named);
}

}  // namespace

TEST_CASE("Names of wheels are understood in the ways people write them") {
  for (const char* name :
       {"ticks_left", "leftTicks", "encL", "left_encoder", "LEFT_ENC", "enc_l", "posL", "count_l"}) {
    INFO(name);
    CHECK(meaning(name).quantity == Quantity::count);
    CHECK(meaning(name).side == NamedSide::left);
  }
  for (const char* name :
       {"cmd_right", "right_setpoint", "targetRight", "v_right_des", "cmdR", "set_speed_r"}) {
    INFO(name);
    CHECK(meaning(name).quantity == Quantity::command);
    CHECK(meaning(name).side == NamedSide::right);
  }
  for (const char* name : {"vel_left", "leftSpeed", "v_l", "rpm_left", "wheelSpeedL"}) {
    INFO(name);
    CHECK(meaning(name).quantity == Quantity::speed);
    CHECK(meaning(name).side == NamedSide::left);
  }
  CHECK(meaning("pwmL").quantity == Quantity::duty);
  CHECK(meaning("right_pwm").side == NamedSide::right);
}

TEST_CASE("A unit at the end of a name is a unit") {
  CHECK(meaning("speed_left_mm_s").unit == "mm/s");
  CHECK(meaning("v_left_mps").unit == "m/s");
  CHECK(meaning("left_rpm").unit == "rpm");
  CHECK(meaning("theta_deg").unit == "deg");
  CHECK(meaning("theta_deg").quantity == Quantity::heading);
  CHECK(meaning("battery_v").quantity == Quantity::battery);
  CHECK(meaning("x_mm").unit == "mm");
  CHECK(meaning("t", "", "ms").unit == "ms");
}

TEST_CASE("A topic says what its channels are") {
  CHECK(meaning("linear.x", "/cmd_vel").quantity == Quantity::linear_command);
  CHECK(meaning("angular.z", "/cmd_vel").quantity == Quantity::angular_command);
  CHECK(meaning("linear.y", "/cmd_vel").quantity == Quantity::unknown);
  CHECK(meaning("twist.twist.linear.x", "/odom").quantity == Quantity::linear_speed);
  CHECK(meaning("pose.pose.position.x", "/odom").quantity == Quantity::x);
  CHECK(meaning("pose.pose.orientation.w", "/odom").quantity == Quantity::qw);
  CHECK(meaning("angular_velocity.z", "/imu").quantity == Quantity::gyro);
  CHECK(meaning("linear_acceleration.x", "/imu").quantity == Quantity::unknown);
}

TEST_CASE("Times are known by their names") {
  for (const char* name :
       {"t", "time", "Time", "timestamp", "%time", "time_ms", "sec", "header.stamp", "bag_time_s"}) {
    INFO(name);
    CHECK(meaning(name).quantity == Quantity::time);
  }
}
