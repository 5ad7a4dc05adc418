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

// `counted` are the counts with the robot's own signs, `travel` those with the sign as it was known at the
// time, both unwrapped and one per reading. Returns the travel with each turn in the row in which the wheel
// was slowest; what was counted there and back in that row is shared out by the rows around it. An encoder
// that tells its direction is known by its counts, whose speed changes more smoothly than any of that.
std::vector<std::int64_t> sign_corrected_travel(std::span<const std::int64_t> counted,
                                                std::span<const std::int64_t> travel);

// Settles the ticks of a drive's samples, which hold travel. `counted` has what the robot counted, one per
// sample; where a sample has no ticks it does not matter.
void settle_travel(DriveLog& drive, std::span<const WheelTicks> counted);

// Of a log of the daemon, which has travel in columns of its own: gives its samples the settled travel as
// their ticks. Other logs stay as they are.
void take_sign_corrected_travel(DriveLog& log);

}  // namespace wheelwright
