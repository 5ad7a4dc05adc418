// Do the commands of a set of runs show what each wheel does?
#pragma once

#include <optional>
#include <span>

#include "model/identification/refusal.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

// Nothing where both wheels were driven, and not always alike: by the energy of the commands, or where little
// of it goes one way, by how sure the counts make the gain that way. Else what is missing and how to get it.
std::optional<Refusal> find_missing_excitation(std::span<const DriveLog> logs);

}  // namespace wheelwright
