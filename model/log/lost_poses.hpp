// Rows in which a tracker did not measure the pose that it says.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wheelwright {

// Rows from `begin` on, before `end`.
struct RowStretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// A number in place of a pose that is lost: 0, -1, -999, 9999. Stretches of x and y, of one stream, in which
// both are the same number and do not change, and one of them comes there by a jump and goes back by a jump
// to about where it was. At either end of a stream, of at least three rows, one jump will do. A jump is five
// times what nine of ten changes from row to row are. Rows that are not finite hold no pose.
std::vector<RowStretch> lost_stretches(std::span<const double> x, std::span<const double> y);

// Poses of another place or heading, for one row to three: `values`, all of them finite, jump there and back
// to about where they were, by more than three times what they change before and after it.
std::vector<RowStretch> outlier_stretches(std::span<const double> values);

// The last pose again while the robot goes on: x, y and heading of one pose for four rows or more, and then a
// jump of one of them. All of them are finite, and headings without wraps.
std::vector<RowStretch> held_stretches(std::span<const double> x, std::span<const double> y,
                                       std::span<const double> heading);

// Not-a-number in all rows of the stretches.
void blank(std::span<const RowStretch> stretches, std::vector<double>& values);

// "the pose is lost in 12 rows (3 times), where x and y are both -999", of lost stretches.
std::string in_words(std::span<const RowStretch> stretches, std::span<const double> x);

}  // namespace wheelwright
