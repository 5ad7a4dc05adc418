// Headings for positions that have none: of satellite navigation, or of a tracker that follows one marker.
//
// The counts say how a wheeled robot turns, and the positions where it came by it. Both go through an
// extended Kalman filter and a Rauch-Tung-Striebel smoother (1965) with the state x, y, heading, and the
// place of the marker ahead of the middle of the axle and left of it, each in m or rad:
//   (x, y, heading) moves along the arc that is counted; position = (x, y) + R(heading) marker + noise.
// Counted motion drifts along the path (slip, a wrong scale) and in heading (a wrong wheel base, a bias), far
// more than that of a good robot does, so that the positions decide over more than a few decimetres. How much
// the positions err is that under which they are likeliest.
#pragma once

#include <optional>

#include "model/log/drive_log.hpp"

namespace wheelwright {

// Whether the run has positions, and no heading at all.
bool has_positions_alone(const DriveLog& log);

// Gives one position in two seconds its heading, that which is known best, takes the others out, and notes
// the noise of these poses in the log: between them headings lean on the counts, which are to be judged by
// them. Nothing, and the log as it was, where it has headings already, no counts, or so little motion that
// the headings stay unknown by more than 0.2 rad.
std::optional<PoseNoise> find_headings(DriveLog& log);

}  // namespace wheelwright
