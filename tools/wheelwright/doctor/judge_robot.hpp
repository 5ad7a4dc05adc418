// From figures to findings: what is good enough to drive with, and what to do where it is not. Pure.
#pragma once

#include <optional>
#include <string>

#include "config/load/daemon_config.hpp"
#include "drivers/open_interface/line_bits.hpp"
#include "tools/wheelwright/doctor/conversation.hpp"
#include "tools/wheelwright/doctor/finding.hpp"

namespace wheelwright::tools::doctor {

// What is known of the port itself.
struct PortFacts {
  std::string device;
  std::string driver;
  std::string other_programs;  // that have it open too, by name
  bool on_board = false;       // a UART of the machine itself
  bool low_latency = false;
  std::optional<int> latency_timer_ms;
};

Finding judge_port(const PortFacts& port);
Finding judge_latency_timer(const PortFacts& port);

// `answering_baud` is absent where the robot answered at none of the speeds that were tried.
Finding judge_baud(const std::string& device, int configured_baud, std::optional<int> answering_baud,
                   std::size_t bytes_received, const std::string& other_programs = "");
// Whether the line passes all eight bits. `bits` is of everything that an answering robot sent.
Finding judge_adapter(const open_interface::LineBits& bits);
// A charging robot prints a line a second, and is well.
Finding judge_text(const ReceivedText& received, bool charging);
Finding judge_mode(const open_interface::Reading& after_start);
Finding judge_battery(const open_interface::Reading& reading, double lowest_v);
Finding judge_replies(const open_interface::ReplyCounts& counts);
Finding judge_round_trip(const std::optional<Spread>& round_trip, const roomba::LinkConfig& link);
Finding judge_checksum(const StreamFigures& stream, roomba::Transport transport);
Finding judge_sensor_period(const StreamFigures& stream, const roomba::LinkConfig& link);
Finding judge_jitter(const StreamFigures& stream, double period_s);

Finding not_tested(const std::string& check, const std::string& why);

}  // namespace wheelwright::tools::doctor
