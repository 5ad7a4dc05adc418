// The moving-average part of `wheelwright fit`.
#pragma once

#include <iosfwd>
#include <vector>

#include "model/drive_log.hpp"
#include "model/identification/fir_fit.hpp"

namespace wheelwright::tools {

// What the fit says of itself, and how far its free run over the same runs is from them.
void print_fir_fit(std::ostream& out, const FirFit& fit, const std::vector<DriveLog>& runs);

}  // namespace wheelwright::tools
