// A run cut into the periods of a model: what eq. (12) is stacked from.
#pragma once

#include <functional>
#include <optional>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// More periods than this between two rows are a hole: what happened inside is not known.
inline constexpr double longest_step_periods = 2.5;

// One period of the model's grid, which starts with the first row of the run.
struct RunPeriod {
  bool in_hole = false;                // touches a hole: its command is not known
  WheelPair command_m_s;               // mean over the period, of what was in force at each moment
  std::optional<WheelPair> speed_m_s;  // mean over the period; absent where no readings are near both ends
};

// Hands on the whole periods of a run in order. Rows need not lie on the grid: commands are integrated
// exactly over their real times, wheel travel is interpolated between the two readings around each end of
// the period (not across a hole). `period_s` is that of the model.
void for_each_period(const DriveLog& log, double period_s,
                     const std::function<void(const RunPeriod&)>& visitor);

}  // namespace wheelwright
