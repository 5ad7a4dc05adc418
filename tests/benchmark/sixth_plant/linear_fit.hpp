#pragma once

#include <vector>

namespace plants::sixth {

// Coefficients of the best linear combination, for several targets at once: solves the normal equations by
// Cholesky. Matrices row by row; of `gram` (n x n) the lower half suffices, `targets` is n x m.
std::vector<double> solved(std::vector<double> gram, std::vector<double> targets, std::size_t n,
                           std::size_t m);

}  // namespace plants::sixth
