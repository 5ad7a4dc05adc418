// Finding out whether a robot listens at the line's speed, with as few bytes as that takes: at the wrong
// speed every byte sent is a random one to the robot, and some opcodes reset it or change its speed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tools/wheelwright/doctor/conversation.hpp"
#include "tools/wheelwright/doctor/robot_line.hpp"

namespace wheelwright::tools::doctor {

// Whether mode, voltage, voltage, mode: the reply to a knock. Any six bytes fit by chance once in 10^7.
bool is_knock_reply(const std::array<std::uint8_t, 6>& bytes);

struct KnockAnswer {
  bool robot_is_there = false;
  std::size_t bytes_received = 0;
};

// Sends Start and a query of four packets. `padded`: first ends a half-sent command, which costs 40 bytes.
KnockAnswer knock(RobotLine& line, bool padded, ReceivedText& received);

}  // namespace wheelwright::tools::doctor
