// What must hold for runs before any model of wheel speeds is fitted to them.
#pragma once

#include <optional>
#include <span>

#include "model/identification/refusal.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

// Nothing where all runs are of one robot and of near periods, hold encoder counts from their first row on,
// hold numbers only, and their commands excite both wheels; else what is missing and how to get it.
std::optional<Refusal> find_unfit_log(std::span<const DriveLog> logs);

}  // namespace wheelwright
