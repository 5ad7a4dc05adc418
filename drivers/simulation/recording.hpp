// A drive of a real robot, to be played back by a robot that answers with what the real one recorded.
//
// Playing starts with the first command to move (137, 145 or 146) that the robot obeys, at the moment of the
// recording at which the real robot was first commanded to move; so a host that drives the same route again
// meets its own run. A command to stand starts nothing: hosts give it before all others, and wait for the
// wheels to obey. Until then the robot stands at that sample; then it answers with each sample from its
// recorded time on; at the end it holds the last one. Only packets 41 to 44 come from the recording. What the
// host commands changes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/simulation/sensor_board.hpp"
#include "drivers/simulation/serial_line.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::simulation {

struct RecordedSample {
  Nanoseconds at{0};  // since the start of the recording, rising
  std::int32_t requested_left_mm_s = 0;
  std::int32_t requested_right_mm_s = 0;
  std::int64_t counts_left = 0;
  std::int64_t counts_right = 0;
};

struct Recording {
  std::vector<RecordedSample> samples;
};

// The part of a drive log that a robot can answer with. Throws std::runtime_error for a log without counts.
Recording recording_of(const DriveLog& log);

// Plays a recording; see above.
class Player {
 public:
  explicit Player(Recording recording);

  // The host has sent a command to move and the robot has obeyed it.
  void drive_commanded(Nanoseconds now);
  // Overwrites packets 41 to 44 with what the recording holds for `now`.
  void answer(SensorBoard& sensors, Nanoseconds now);

 private:
  Recording recording_;
  std::size_t position_ = 0;
  std::optional<Nanoseconds> started_;  // when the recording's time zero was
};

}  // namespace wheelwright::simulation
