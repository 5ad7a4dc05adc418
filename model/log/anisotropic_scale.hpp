// A reference whose metre is longer in one direction of the room than across it: a camera that looks at the
// floor at a slant, pixels that are not square.
//
// Found beside the counts, whose metre is the same in all directions. In each window (counted_windows.hpp)
//
//   (x, y)_ref = g (x, y) + a (x, -y) + b (y, x),
//
// with the path (x, y) by the counts, beside what a delay and the window's own drift make of it. Standard
// errors are those of leaving out each window in turn (Efron and Stein, Annals of Statistics 9, 1981). Two
// markers of a robot that are seen through such a camera have a heading that errs by b' cos 2 theta - a' sin
// 2 theta; a' and b' are found by the headings, which may be right.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/log/drive_log.hpp"

namespace wheelwright {

struct AnisotropicScale {
  double gain = 1.0;     // g: metres of the reference for each metre of the counts, on average
  double along = 0.0;    // a: what x has more, and y less, than that; relative to g, as all that follows
  double oblique = 0.0;  // b: the same along the two diagonals
  double heading_along_rad = 0.0;    // a'; 0 where it is not sure
  double heading_oblique_rad = 0.0;  // b'; likewise

  double largest_over_least() const;
  double longest_direction_rad() const;  // of the room; 0 to pi
};

// Sure is what exceeds five standard errors, and what each half of the windows shows to within a half.
// Not all is found: a steep floor, which moves the robot by its heading, has hidden 3 %, and beside a long
// lever arm 2.5 of 3 % were found.
//
// Over all runs of one tracker, whose response to the motion is that of the first run. Nothing where the
// metre is the same in all directions, or not surely another.
std::optional<AnisotropicScale> find_anisotropic_scale(std::span<const DriveLog* const> runs);

// Puts the places and headings of a run right. Its metre is that of the counts then: what is left says
// nothing of how far a count goes.
void undo_anisotropic_scale(DriveLog& run, const AnisotropicScale& scale);

// "the reference's metre is 1.5 % longer along 30 deg of its frame than across, ..."
std::string in_words(const AnisotropicScale& scale);

}  // namespace wheelwright
