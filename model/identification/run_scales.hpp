// Runs of one robot whose counts do not go as far for their commands as those of the others: other firmware,
// other wheels, or an encoder that is read at other edges.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "model/log/drive_log.hpp"

namespace wheelwright {

struct ScaleOutlier {
  std::size_t run = 0;
  double factor = 1.0;    // of the travel that the other runs have for the same commands
  std::size_t other = 0;  // a run of the others
};

// The run that differs most from the others, on both wheels, by more than a battery or a floor makes; nothing
// where none does, or where the others do not agree among themselves.
std::optional<ScaleOutlier> find_scale_outlier(std::span<const DriveLog> runs);

}  // namespace wheelwright
