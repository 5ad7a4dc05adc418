// The poles of a wheel's response: what it does by itself once commands have ended.
#pragma once

#include <complex>
#include <vector>

#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// Eigenvalues of the companion matrix of `from_own_past`, in periods: inside the unit circle is stable.
// Conjugate pairs stand side by side; empty for a response without a past of its own.
std::vector<std::complex<double>> poles(const WheelResponse& response);

}  // namespace wheelwright
