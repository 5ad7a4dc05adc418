// The clock of a reference that was recorded by another machine, against that of the robot.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct ClockShift {
  double seconds = 0.0;  // to be added to the stamps of the reference; with a rate, to the first of them
  double rate = 1.0;     // seconds of the robot's clock in one of the reference's, from its first stamp on
  double correlation = 0.0;  // of the speeds of both
  std::string evidence;
};

// The shift at which the speed of the reference and that of the wheels (without wheels: that of the commands)
// agree best: largest correlation, over all shifts at which at least half of the shorter record lies in the
// other. Fails, with one line, where none stands out.
//
// A rate is found where the best shifts of parts of the drive lie on a line that leads away from one shift by
// more than 30 ms and by five times what they scatter about it: a ceramic resonator is off by up to 0.5 %.
tl::expected<ClockShift, std::string> find_clock_shift(std::span<const Recording> recordings,
                                                       const Mapping& mapping);

}  // namespace wheelwright::import
