#include "model/identification/least_squares_accumulator.hpp"

#include <cmath>

// Compiles a function for the wider registers of newer processors too. Without fused multiplication and with
// the order of each sum fixed below, every variant gives the same bits. Sanitizers cannot stand the choice at
// start-up.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__SANITIZE_ADDRESS__)
#define WHEELWRIGHT_FOR_WIDE_REGISTERS [[gnu::target_clones("avx2", "default")]]
#else
#define WHEELWRIGHT_FOR_WIDE_REGISTERS
#endif

namespace wheelwright {
namespace {

constexpr Eigen::Index lanes = 4;

// Adds in `lanes` sums side by side. `size` is a multiple of `lanes`, here and below.
[[gnu::always_inline]] inline double dot(const double* a, const double* b, Eigen::Index size) {
  double sums[lanes] = {};
  for (Eigen::Index k = 0; k < size; k += lanes) {
    for (Eigen::Index lane = 0; lane < lanes; ++lane) sums[lane] += a[k + lane] * b[k + lane];
  }
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

// The Householder reflection I - scale [1; v] [1; v]^T that maps a column, `diagonal` above `v`, onto its
// first element alone. It touches a single row of the triangle, because the rest of that column is zero
// already. Returns the scale, 0 where there is nothing to reflect.
[[gnu::always_inline]] inline double make_reflection(double& diagonal, double* v, Eigen::Index size) {
  const double below = dot(v, v, size);
  if (below == 0.0) return 0.0;
  const double old = diagonal;
  diagonal = -std::copysign(std::sqrt(old * old + below), old);
  const double factor = 1.0 / (old - diagonal);
  for (Eigen::Index k = 0; k < size; ++k) v[k] *= factor;
  return (diagonal - old) / diagonal;
}

// QR of the triangle (width x width, by columns) stacked on `size` rows of the block (by columns, `stride`
// apart). Two reflections at a time, so that every column is fetched and stored half as often.
WHEELWRIGHT_FOR_WIDE_REGISTERS
void fold_block(double* triangle, double* block, Eigen::Index width, Eigen::Index stride, Eigen::Index size) {
  for (Eigen::Index j = 0; j < width; j += 2) {
    double* v = block + j * stride;
    const double scale_v = make_reflection(triangle[j + j * width], v, size);
    if (j + 1 == width) return;
    double* w = v + stride;
    double& beside = triangle[j + (j + 1) * width];
    const double step = scale_v * (beside + dot(v, w, size));
    beside -= step;
    for (Eigen::Index k = 0; k < size; ++k) w[k] -= step * v[k];
    const double scale_w = make_reflection(triangle[j + 1 + (j + 1) * width], w, size);
    const double both = dot(v, w, size);
    for (Eigen::Index c = j + 2; c < width; ++c) {
      double* y = block + c * stride;
      double* above = triangle + j + c * width;
      const double step_v = scale_v * (above[0] + dot(v, y, size));
      const double step_w = scale_w * (above[1] + dot(w, y, size) - both * step_v);
      above[0] -= step_v;
      above[1] -= step_w;
      for (Eigen::Index k = 0; k < size; ++k) y[k] -= step_v * v[k] + step_w * w[k];
    }
  }
}

}  // namespace

LeastSquaresAccumulator::LeastSquaresAccumulator(Eigen::Index unknowns, Eigen::Index outputs)
    : unknowns_(unknowns),
      outputs_(outputs),
      triangle_(Eigen::MatrixXd::Zero(unknowns + outputs, unknowns + outputs)),
      block_(Block::Zero(block_rows, unknowns + outputs)) {}

void LeastSquaresAccumulator::add_row(const Eigen::Ref<const Eigen::RowVectorXd>& regressors,
                                      const Eigen::Ref<const Eigen::RowVectorXd>& targets) {
  if (pending_ == block_rows) fold();
  block_.row(pending_).head(unknowns_) = regressors;
  block_.row(pending_).tail(outputs_) = targets;
  ++pending_;
  ++rows_;
}

void LeastSquaresAccumulator::fold() {
  if (pending_ == 0) return;
  const Eigen::Index size = (pending_ + lanes - 1) / lanes * lanes;
  fold_block(triangle_.data(), block_.data(), unknowns_ + outputs_, block_rows, size);
  block_.topRows(size).setZero();
  pending_ = 0;
}

LeastSquaresAccumulator::Factor LeastSquaresAccumulator::factor() {
  fold();
  Factor result;
  result.r = triangle_.topLeftCorner(unknowns_, unknowns_);
  result.z = triangle_.topRightCorner(unknowns_, outputs_);
  result.residual_square_sum = triangle_.bottomRightCorner(outputs_, outputs_).colwise().squaredNorm();
  result.rows = rows_;
  return result;
}

}  // namespace wheelwright
