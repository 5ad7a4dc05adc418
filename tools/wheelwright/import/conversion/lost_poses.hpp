// Rows in which a tracker that has lost the robot says a number in place of the pose: 0, -1, -999, 9999.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wheelwright::import {

// Rows from `begin` on, before `end`.
struct LostStretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Stretches of x and y, of one stream, in which both are the same number and do not change, and one of them
// comes there by a jump and goes back by a jump to about where it was. At either end of a stream, of at least
// three rows, one jump will do. A jump is five times what nine of ten changes from row to row are.
std::vector<LostStretch> lost_stretches(std::span<const double> x, std::span<const double> y);

// Not-a-number in all rows of the stretches.
void blank(std::span<const LostStretch> stretches, std::vector<double>& values);

// "the pose is lost in 3 stretches (12 rows), where x and y are -999".
std::string in_words(std::span<const LostStretch> stretches, std::span<const double> x);

}  // namespace wheelwright::import
