// Which wheels count backwards, by their commands.
#pragma once

#include <array>

#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

inline constexpr double unit_explained = 0.5;  // share of the variance from which a gain is believed

// 1, or -1 of a wheel that counts backwards, left and right: as it goes against its command where `fits`, of
// each wheel by its own command, are believed; else as is stated.
std::array<double, 2> wheel_directions(const Mapping& mapping, const std::array<ResponseFit, 2>& fits);

}  // namespace wheelwright::import
