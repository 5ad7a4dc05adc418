#include "tests/benchmark/sixth_plant/linear_fit.hpp"

#include <algorithm>
#include <cmath>

namespace plants::sixth {

namespace {

// Commands that follow each other are nearly alike.
void add_ridge(std::vector<double>& gram, std::size_t n) {
  double trace = 0;
  for (std::size_t row = 0; row < n; ++row) trace += gram[row * n + row];
  for (std::size_t row = 0; row < n; ++row)
    gram[row * n + row] += 1e-9 * trace / static_cast<double>(n) + 1e-15;
}

void factorise(std::vector<double>& gram, std::size_t n) {
  for (std::size_t column = 0; column < n; ++column) {
    double pivot = gram[column * n + column];
    for (std::size_t k = 0; k < column; ++k) pivot -= gram[column * n + k] * gram[column * n + k];
    gram[column * n + column] = std::sqrt(std::max(pivot, 1e-18));
    for (std::size_t row = column + 1; row < n; ++row) {
      double rest = gram[row * n + column];
      for (std::size_t k = 0; k < column; ++k) rest -= gram[row * n + k] * gram[column * n + k];
      gram[row * n + column] = rest / gram[column * n + column];
    }
  }
}

void substitute(const std::vector<double>& factor, std::vector<double>& targets, std::size_t n, std::size_t m,
                std::size_t target) {
  for (std::size_t row = 0; row < n; ++row) {
    double rest = targets[row * m + target];
    for (std::size_t k = 0; k < row; ++k) rest -= factor[row * n + k] * targets[k * m + target];
    targets[row * m + target] = rest / factor[row * n + row];
  }
  for (std::size_t row = n; row-- > 0;) {
    double rest = targets[row * m + target];
    for (std::size_t k = row + 1; k < n; ++k) rest -= factor[k * n + row] * targets[k * m + target];
    targets[row * m + target] = rest / factor[row * n + row];
  }
}

}  // namespace

std::vector<double> solved(std::vector<double> gram, std::vector<double> targets, std::size_t n,
                           std::size_t m) {
  add_ridge(gram, n);
  factorise(gram, n);
  for (std::size_t target = 0; target < m; ++target) substitute(gram, targets, n, m, target);
  return targets;
}

}  // namespace plants::sixth
