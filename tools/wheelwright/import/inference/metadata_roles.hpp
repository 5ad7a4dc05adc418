// What the metadata of a file say of a mapping.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// The wheel base, period, scales and name that metadata state ("# wheel_base_m: 0.235"), the unit of lengths
// of a motion capture system, and the rate of rows that have no clock ("fps: 30"), also as a column of one
// number.
void map_metadata(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& doubts);

// Gives the tables of a file that states a rate and has no clock one: by the number of the frame, else of the
// row.
void stamp_frames(Recording& recording);

}  // namespace wheelwright::import
