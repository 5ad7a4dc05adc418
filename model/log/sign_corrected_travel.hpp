// A wheel's travel as it is known afterwards.
//
// Which way a wheel turns is known some samples late where its encoder does not tell
// (drivers/open_interface/encoder_counter.hpp): until then travel goes on in the old direction, and what was
// wrong is made up for in a single row. That is all that can be done while the robot drives. Whoever looks at
// a recorded drive knows more: the rows in between can be put right.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// Travel, and the counts that it was made of: with the robot's own signs and with the sign as it was known at
// the time. Both unwrapped, one per reading.
struct CountedTravel {
  std::vector<std::int64_t> counted;
  std::vector<std::int64_t> travel;
};

// Returns the travel with each turn in the row in which the wheel was slowest; what was counted there and
// back in that row is shared out by the rows around it. Encoders that tell their direction are known by their
// counts, whose speed changes more smoothly than any of that. All wheels and runs are of one robot, whose
// encoders are alike: a single stop, in which counts that went on forward look as smooth as counts that went
// back, does not decide it.
std::vector<std::vector<std::int64_t>> sign_corrected_travel(std::span<const CountedTravel> runs);

// Settles the ticks of the samples of a robot's drives, which hold travel. `counted` has what the robot
// counted: for each drive one entry per sample; where a sample has no ticks it does not matter.
void settle_travel(std::span<DriveLog> drives, std::span<const std::vector<WheelTicks>> counted);

// Of the runs of a log of the daemon, which has travel in columns of its own: gives their samples the settled
// travel as their ticks. Other logs stay as they are.
void take_sign_corrected_travel(std::span<DriveLog> runs);

}  // namespace wheelwright
