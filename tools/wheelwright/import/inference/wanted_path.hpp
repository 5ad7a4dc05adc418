// A path that is wanted beside one that was measured.
#pragma once

#include <cstdint>
#include <vector>

namespace wheelwright::import {

struct PlacePath {
  const std::vector<double>& x;
  const std::vector<double>& y;
};

enum class PathKind : std::uint8_t { wanted, measured, unclear };

// What a path may be, row by row beside another of the same robot. It is wanted if it stands for most rows,
// if the other follows it by two rows or more, or if it is smooth and the other has noise; measured if it is
// the one with noise.
PathKind path_kind(const PlacePath& path, const PlacePath& other);

}  // namespace wheelwright::import
