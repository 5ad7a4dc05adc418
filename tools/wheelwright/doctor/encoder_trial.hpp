// Which counter belongs to which wheel, found out by moving one wheel: the only check that moves the robot.
#pragma once

#include "config/load/daemon_config.hpp"
#include "model/log/sensor_frame.hpp"
#include "tools/wheelwright/doctor/conversation.hpp"
#include "tools/wheelwright/doctor/finding.hpp"
#include "tools/wheelwright/doctor/robot_line.hpp"

namespace wheelwright::tools::doctor {

// What happened when the left wheel was told to turn.
struct EncoderTrial {
  bool armed = false;  // the robot accepted Safe mode
  StopReason stop = StopReason::none;
  double ticks_43 = 0.0;  // of each counter, out and back together
  double ticks_44 = 0.0;
  double expected_ticks = 0.0;
};

// Drives the left wheel at 0.05 m/s for half a second, and back, in Safe mode. A bump, a cliff, a wheel drop,
// a charger, an overcurrent, a low battery or silent sensors stop it at once, as in the daemon. The robot is
// at rest and in Passive mode afterwards. `slowest_reply_s` is how long a query may take.
EncoderTrial try_left_wheel(RobotLine& line, const config::DaemonConfig& config, double slowest_reply_s);

// Pure.
Finding judge_encoders(const EncoderTrial& trial, const config::DaemonConfig& config);

}  // namespace wheelwright::tools::doctor
