// The moving-average part of `wheelwright fit`.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <vector>

#include "model/identification/fir_fit.hpp"
#include "model/log/drive_log.hpp"
#include "model/prediction/score.hpp"

namespace wheelwright::tools {

// How far the fit's free run over the known segments of its own runs is from them.
Score score_of_fir_fit(const FirFit& fit, const std::vector<DriveLog>& runs);

// What the fit says of itself, and that score.
void print_fir_fit(std::ostream& out, const FirFit& fit, std::size_t runs, const Score& score);

}  // namespace wheelwright::tools
