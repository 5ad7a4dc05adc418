// A reference whose heading is turned on the robot: markers that were taken for its front when the tracker
// learnt them, or a heading that counts from the y axis.
//
// A robot with two wheels moves along its heading, so that the offset can be seen while it drives. Motion of
// the reference between two of its poses, half a second or more apart, in the direction half-way through the
// turn: forward f and aside a. The offset is arctan(c1) of
//
//   a = c1 f + c2 turn + c3 f turn / dt + dt (c4 cos(heading) + c5 sin(heading))
//
// by least squares: c2 is a lever arm, c3 a heading that comes late and tyres that slide outwards, c4 and c5
// a floor on which the robot creeps sideways. The standard error is that of clusters of 5 s (Liang and Zeger,
// Biometrika 73, 1986).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

struct HeadingOffset {
  double offset_rad = 0.0;  // to be added to the heading; -pi to pi
  double standard_error_rad = 0.0;
};

// Over all runs. Nothing where the motion does not tell: without places and headings, in less than fifty
// seconds, without straight driving, or where x, y and heading belong to no right-handed frame.
std::optional<HeadingOffset> find_heading_offset(std::span<const DriveLog* const> runs);

// Whether an offset is sure (five standard errors), large enough to matter (5 mrad), and not
// so near to half a turn that it may as well be commands of the other sign.
bool is_turned(const HeadingOffset& offset);

void turn_headings(DriveLog& run, double by_rad);

// The offset of each of the runs of one tracker: that of all together, unless a run contradicts it; 0 where
// there is none.
std::vector<HeadingOffset> heading_offsets(std::span<const DriveLog* const> runs);

// "the heading of the reference is turned by 2.86 deg against the way that it moves (95 %: 2.8 to 2.92)"
std::string in_words(const HeadingOffset& offset);

}  // namespace wheelwright
