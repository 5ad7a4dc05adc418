// A reference whose heading is not that of the robot: markers that were taken for its front when the tracker
// learnt them, a heading that counts from the y axis, a yaw that drifts or is out of scale, as that of a
// gyro.
//
// A robot with two wheels moves along its heading, so that the offset can be seen while it drives. Motion of
// the reference between two of its poses, half a second or more apart, in the direction half-way through the
// turn: forward f and aside a. The offset is arctan(c1) of
//
//   a = f (c1 + c6 t + c7 h) + c2 turn + c3 f turn / dt + dt (c4 cos(heading) + c5 sin(heading))
//
// by least squares: c2 is a lever arm, c3 a heading that comes late and tyres that slide outwards, c4 and c5
// a floor on which the robot creeps sideways, c6 a drift over the time t, and c7 a scale of the angle h that
// the heading has turned, both about their means, and only if they are sure and show within runs as well.
// Standard errors are those of clusters of 5 s (Liang and Zeger, Biometrika 73, 1986), made larger for few
// clusters, so that as many of them are as sure as by Student's t.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// What is to be added to a heading.
struct HeadingOffset {
  double offset_rad = 0.0;  // on average; -pi to pi
  double standard_error_rad = 0.0;
  double drift_rad_per_s = 0.0;  // for the time since the run began, less `mean_t_s`; 0 where none is sure
  double per_radian = 0.0;       // for what it has turned since then, less `mean_turned_rad`; 0 likewise
  double mean_t_s = 0.0;
  double mean_turned_rad = 0.0;
};

// Over all runs. Nothing where the motion does not tell: without places and headings, in less than fifty
// seconds, without straight driving, or where x, y and heading belong to no right-handed frame.
std::optional<HeadingOffset> find_heading_offset(std::span<const DriveLog* const> runs);

// Whether there is something to be added: an offset that is sure (five standard errors), large enough to
// matter (5 mrad), and not so near to half a turn that it may as well be commands of the other sign; a drift,
// a scale.
bool is_turned(const HeadingOffset& offset);

void turn_headings(DriveLog& run, const HeadingOffset& offset);

// The offset of each of the runs of one tracker: that of all together, unless a run contradicts it; all zero
// where there is none.
std::vector<HeadingOffset> heading_offsets(std::span<const DriveLog* const> runs);

// "the heading of the reference is turned by 2.86 deg against the way that it moves (95 %: 2.8 to 2.92),
// drifts by 2 deg a minute"
std::string in_words(const HeadingOffset& offset);

}  // namespace wheelwright
