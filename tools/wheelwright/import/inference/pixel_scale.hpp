// How far a pixel of a reference is on the floor, by how far the robot goes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

// Sets `reference.metres_per_pixel` of places in pixels, by the wheels, else by commands that are speeds.
// Places that no one gives a unit are pixels too if they go more than three times as far as the robot in
// metres, or less than a third, and no unit of length explains it: with a doubt. Where the file says metres
// it is a doubt alone.
void infer_pixel_scale(std::span<const Recording> recordings, const DriveColumns& columns,
                       const GivenMapping& given, Mapping& mapping, std::vector<std::string>& findings,
                       std::vector<std::string>& doubts);

}  // namespace wheelwright::import
