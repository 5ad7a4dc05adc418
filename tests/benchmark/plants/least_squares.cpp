#include "tests/benchmark/plants/least_squares.hpp"

#include <algorithm>

namespace plants {

LeastSquares::LeastSquares(std::size_t regressors) : size_(regressors + 1), gram_(size_ * size_, 0.0) {}

void LeastSquares::add(const std::vector<double>& regressors, double target) {
  const auto value = [&](std::size_t index) { return index + 1 < size_ ? regressors[index] : target; };
  for (std::size_t row = 0; row < size_; ++row)
    for (std::size_t column = 0; column < size_; ++column)
      gram_[row * size_ + column] += value(row) * value(column);
  ++rows_;
}

double LeastSquares::remaining_mean_square() const {
  // Eliminating every regressor leaves the residual sum of squares in the last corner.
  std::vector<double> work = gram_;
  for (std::size_t pivot = 0; pivot + 1 < size_; ++pivot) {
    const double diagonal = work[pivot * size_ + pivot] + 1.0e-9 * gram_[pivot * size_ + pivot] + 1.0e-15;
    for (std::size_t row = pivot + 1; row < size_; ++row) {
      const double factor = work[row * size_ + pivot] / diagonal;
      for (std::size_t column = pivot; column < size_; ++column)
        work[row * size_ + column] -= factor * work[pivot * size_ + column];
    }
  }
  return std::max(0.0, work.back()) / static_cast<double>(std::max(1L, rows_));
}

double LeastSquares::mean_square() const {
  return gram_.back() / static_cast<double>(std::max(1L, rows_));
}

}  // namespace plants
