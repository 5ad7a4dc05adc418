// What is usual of the errors of a stretch between two far references.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

// Covariance of x, y (m) and heading (rad) of the second pose seen from the first, before the data say
// better: wandering in distance and heading, carried to the end of the stretch along the path that odometry
// shows (without counts: along the straight line between the references), and the readings' own noise.
// `stretch` counts from 0, from the first reference of the run to the second.
Eigen::Matrix3d usual_stretch_covariance(const GapRun& run, std::size_t stretch);

}  // namespace wheelwright::gap
