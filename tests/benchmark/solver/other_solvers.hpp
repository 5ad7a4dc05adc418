// Least-squares solvers that others use, where this machine has them.
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

namespace wheelwright::benchmarks {

// A x = b in the sense of least squares. By rows, as both solvers read it.
struct DenseSystem {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> a;
  Eigen::VectorXd b;
};

// cv::solve(DECOMP_SVD). The system is brought into OpenCV's own layout once, outside of what is timed.
class OpenCvSolver {
 public:
  explicit OpenCvSolver(const DenseSystem& system);
  ~OpenCvSolver();
  OpenCvSolver(const OpenCvSolver&) = delete;
  OpenCvSolver& operator=(const OpenCvSolver&) = delete;

  static bool installed();  // when this program was built
  bool available() const { return installed(); }
  void solve();
  Eigen::VectorXd solution() const;

 private:
  struct Matrices;
  std::unique_ptr<Matrices> matrices_;
};

struct OctaveResult {
  double residual_norm = 0.0;
  double seconds = 0.0;  // of the call of arx alone, without the start of Octave
};

bool octave_installed();

// `arx` of the control package on the same two commands and one output; nothing where it cannot be run.
// It leaves out the first rows, whose past is rest, so its residual is of slightly fewer rows.
std::optional<OctaveResult> solve_by_octave(const DenseSystem& system);

}  // namespace wheelwright::benchmarks
