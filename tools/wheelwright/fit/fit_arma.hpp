// The ARMA part of `wheelwright fit`.
#pragma once

#include <iosfwd>
#include <vector>

#include "model/identification/arma_fit.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::tools {

// Fits, and shows on a terminal how far a sweep of orders has come.
tl::expected<ArmaFit, Refusal> fit_arma(const std::vector<DriveLog>& runs, ArmaFitOptions options,
                                        std::ostream& err);

// The table of orders, where there was a sweep, and what the fit says of itself.
void print_arma_fit(std::ostream& out, const ArmaFit& fit, std::size_t runs);

}  // namespace wheelwright::tools
