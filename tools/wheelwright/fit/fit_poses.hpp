// The part of `wheelwright fit` for runs that hold reference poses and no encoder counts.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/gap/pose_fit.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::tools {

// Throws DataRefusal where the poses do not show a model.
gap::PoseFit fit_poses(const std::vector<DriveLog>& runs, std::ostream& err);

// What the fit says of itself.
void print_pose_fit(std::ostream& out, const gap::PoseFit& fit, std::size_t runs);
nlohmann::ordered_json pose_fit_json(const gap::PoseFit& fit, std::size_t runs,
                                     const std::string& model_file);

}  // namespace wheelwright::tools
