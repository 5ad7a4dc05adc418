// In which directions a robot went.
#pragma once

#include <array>
#include <cstddef>

#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// The directions of travel of some runs, each reckoned from its first reference heading by its counts, or by
// its commands where there are none.
class TravelDirections {
 public:
  void add(const DriveLog& log);
  // Whether no half turn holds them all.
  bool all_round() const;

 private:
  static constexpr std::size_t sectors = 180;
  std::array<bool, sectors> seen_{};
};

}  // namespace wheelwright::gap
