// What the doctor asks a robot that stands still, and the figures that come of it.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "drivers/open_interface/query_reader.hpp"
#include "drivers/open_interface/stream_reader.hpp"
#include "tools/wheelwright/doctor/period_fit.hpp"
#include "tools/wheelwright/doctor/robot_line.hpp"

namespace wheelwright::tools::doctor {

// Readable text that came by itself.
struct ReceivedText {
  std::vector<std::string> lines;  // each once, in order of appearance
  int count = 0;                   // of all lines, with those that came again
  int starts = 0;                  // how often the robot said that it boots
};

// Moves a finished run of text to `received`; returns its length, 0 where there is none.
std::size_t collect_text(open_interface::StrayText& text, ReceivedText& received);

// What was received of a robot that was told to start.
struct Greeting {
  std::optional<open_interface::Reading> reading;  // nothing where no sound reply came
  std::size_t bytes_received = 0;
};

// Says nothing and listens.
void listen(RobotLine& line, std::chrono::milliseconds duration, ReceivedText& received);

// Ends a half-sent command, stops the wheels, starts the Open Interface (Passive), and asks for a reply until
// one comes, for at most `patience`.
Greeting greet(RobotLine& line, std::chrono::milliseconds patience, ReceivedText& received);

struct QueryFigures {
  open_interface::ReplyCounts counts;
  std::optional<Spread> round_trip;  // from the query's first byte to the reply's last
  std::optional<open_interface::Reading> last;
};

// Asks once per period, and gives each reply as long as it takes: up to 0.1 s.
QueryFigures ask_repeatedly(RobotLine& line, double period_s, int times, ReceivedText& received);

struct StreamFigures {
  open_interface::ChecksumRule rule = open_interface::ChecksumRule::unknown;
  open_interface::StreamCounts counts;
  std::int64_t sent = 0;  // frames, by the bytes that came up to the last sound one
  std::optional<PeriodFit> period;
};

// Lets the robot stream, and pauses the stream again.
StreamFigures listen_to_stream(RobotLine& line, std::chrono::milliseconds duration, ReceivedText& received);

// Bytes of a stream frame with all packets that the project uses, which must fit into the robot's 15 ms.
std::size_t stream_frame_bytes();

}  // namespace wheelwright::tools::doctor
