#include "tests/benchmark/solver/other_solvers.hpp"

#ifdef WHEELWRIGHT_HAS_OPENCV
#include <opencv2/core.hpp>
#endif

namespace wheelwright::benchmarks {

#ifdef WHEELWRIGHT_HAS_OPENCV

struct OpenCvSolver::Matrices {
  cv::Mat a;
  cv::Mat b;
  cv::Mat x;
};

OpenCvSolver::OpenCvSolver(const DenseSystem& system) : matrices_(std::make_unique<Matrices>()) {
  const auto rows = static_cast<int>(system.a.rows());
  const auto columns = static_cast<int>(system.a.cols());
  matrices_->a.create(rows, columns, CV_64F);
  matrices_->b.create(rows, 1, CV_64F);
  for (int k = 0; k < rows; ++k) {
    for (int i = 0; i < columns; ++i) matrices_->a.at<double>(k, i) = system.a(k, i);
    matrices_->b.at<double>(k, 0) = system.b[k];
  }
}

bool OpenCvSolver::installed() {
  return true;
}

void OpenCvSolver::solve() {
  cv::solve(matrices_->a, matrices_->b, matrices_->x, cv::DECOMP_SVD);
}

Eigen::VectorXd OpenCvSolver::solution() const {
  return Eigen::Map<const Eigen::VectorXd>(matrices_->x.ptr<double>(), matrices_->x.rows);
}

#else

struct OpenCvSolver::Matrices {};

OpenCvSolver::OpenCvSolver(const DenseSystem&) {}

bool OpenCvSolver::installed() {
  return false;
}

void OpenCvSolver::solve() {}

Eigen::VectorXd OpenCvSolver::solution() const {
  return {};
}

#endif

OpenCvSolver::~OpenCvSolver() = default;

}  // namespace wheelwright::benchmarks
