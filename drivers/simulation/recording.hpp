// A drive of a real robot, to be played back by a robot that answers with what the real one recorded.
//
// Playing starts with the first drive command (137, 145 or 146) that the robot obeys. Until then it answers
// with the first sample that comes before the recorded robot was first commanded to move, at rest; then with
// each sample at its recorded time; after the last one it holds that. Only packets 41 to 44 come from the
// recording; the host's own speeds change nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wheelwright::simulation {

struct RecordedSample {
  double t_s = 0.0;  // rising
  double command_left_m_s = 0.0;
  double command_right_m_s = 0.0;
  std::int64_t counts_left = 0;
  std::int64_t counts_right = 0;
};

struct Recording {
  std::vector<RecordedSample> samples;
};

}  // namespace wheelwright::simulation
