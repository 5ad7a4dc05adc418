#pragma once

#include <vector>

namespace plants {

// Sum of squares that remains of the target after the best linear combination of the regressors.
class LeastSquares {
 public:
  explicit LeastSquares(std::size_t regressors);

  void add(const std::vector<double>& regressors, double target);
  [[nodiscard]] double remaining_mean_square() const;
  [[nodiscard]] double mean_square() const;

 private:
  std::size_t size_;
  std::vector<double> gram_;  // of regressors and target, row by row
  long rows_ = 0;
};

}  // namespace plants
