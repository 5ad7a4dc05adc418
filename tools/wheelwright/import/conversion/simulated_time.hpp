// Recordings of a simulation that runs slower or faster than the clock of the recorder: what happened when is
// said by the stamps of the messages, and not by when they were recorded.
#pragma once

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Where the stamps of all topics that have any go at one rate that is not that of the recorder, all topics
// get the time of the stamps, those without stamps by what the others had been stamped with when they were
// recorded. A line in the recording's remarks then.
void take_simulated_time(Recording& recording);

}  // namespace wheelwright::import
