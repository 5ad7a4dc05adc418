// What is usual of the errors of a segment between two far references.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

// Covariance of x, y (m) and heading (rad) of the second pose seen from the first, before the data say
// better: drifting in distance and heading, carried to the end of the segment along the path that odometry
// shows (without counts: along the straight line between the references), and the readings' own noise.
// `segment` counts from 0, from the first reference of the run to the second.
Eigen::Matrix3d default_segment_covariance(const GapRun& run, std::size_t segment);

}  // namespace wheelwright::gap
