// Four columns without names that are a quaternion, whose heading a reference has.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct QuaternionColumns {
  const Channel* x = nullptr;
  const Channel* y = nullptr;
  const Channel* z = nullptr;
  const Channel* w = nullptr;
  std::vector<double> heading_rad;  // within one turn; not-a-number where a part is missing

  bool has(const Channel* channel) const {
    return channel == x || channel == y || channel == z || channel == w;
  }
};

// The first four neighbours of `stream` among `unused` whose squares sum to one in every row, of a robot that
// stands on the floor: x and y are small. The real part stands last or first.
std::optional<QuaternionColumns> find_quaternion(const Stream& stream,
                                                 const std::vector<const Channel*>& unused);

// Whether four neighbours that are a quaternion of a robot on the floor are w, x, y, z and not x, y, z, w.
bool has_real_part_first(std::span<const Channel, 4> four);

}  // namespace wheelwright::import
