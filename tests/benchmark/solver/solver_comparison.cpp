// solver_comparison: the same ARMA systems (order 9, one wheel) by this project's accumulating solver, by
// OpenCV's cv::solve(DECOMP_SVD), which is the paper's choice, and by `arx` of octave-control. The last two
// where they are installed. Prints residual norm and time, and exits with 1 where a goal is missed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "model/identification/arma_accumulator.hpp"
#include "model/identification/least_squares_solution.hpp"
#include "model/log/run_periods.hpp"
#include "tests/benchmark/solver/other_solvers.hpp"
#include "tests/support/plant_run.hpp"

namespace wheelwright::benchmarks {
namespace {

constexpr std::size_t order = 9;
constexpr double min_speed_up = 10.0;           // over cv::solve, at 1000 rows
constexpr double max_residual_change = 1e-9;    // relative
constexpr double longest_final_solve_s = 1e-4;  // in live use

// A run of the published plant with a Create 2's ticks, cut into periods.
std::vector<RunPeriod> periods_of_run(std::size_t rows) {
  const DriveLog log = test::plant_run({.rows = rows + 1, .metres_per_tick = test::create2_tick_m});
  std::vector<RunPeriod> periods;
  for_each_period(log, log.period_s, [&](const RunPeriod& period) { periods.push_back(period); });
  return periods;
}

// The left wheel's rows of eq. (12) as one matrix, for solvers that want it whole.
DenseSystem dense_system(const std::vector<RunPeriod>& periods) {
  const ArmaLayout layout{order, 0};
  const auto count = static_cast<Eigen::Index>(periods.size());
  DenseSystem system{decltype(DenseSystem::a)::Zero(count, layout.columns()), Eigen::VectorXd::Zero(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = [&](Eigen::Index period) { return periods[static_cast<std::size_t>(period)]; };
    for (Eigen::Index i = 0; i <= static_cast<Eigen::Index>(order) && i <= k; ++i) {
      system.a(k, 2 * i) = at(k - i).command_m_s.left;
      system.a(k, 2 * i + 1) = at(k - i).command_m_s.right;
      if (i > 0) system.a(k, layout.command_columns() + i - 1) = at(k - i).speed_m_s->left;
    }
    system.b[k] = at(k).speed_m_s->left;
  }
  return system;
}

// Median time of one call, in seconds.
template <typename Call>
double seconds_of(Call call) {
  std::vector<double> times;
  for (int i = 0; i < 51; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + 25, times.end());
  return times[25];
}

void print(std::size_t rows, const char* solver, double residual, double seconds) {
  std::printf("%6zu  %-34s %22.15e %12.4f\n", rows, solver, residual, 1e3 * seconds);
}

bool check(bool met, const char* goal) {
  std::printf("        goal: %-58s %s\n", goal, met ? "met" : "NOT MET");
  return met;
}

struct Timed {
  double residual = 0.0;
  double seconds = 0.0;
};

Timed measure_accumulator(const DenseSystem& system) {
  Eigen::VectorXd solution;
  const auto solve = [&] {
    LeastSquaresAccumulator accumulator(system.a.cols(), 1);
    for (Eigen::Index k = 0; k < system.a.rows(); ++k) accumulator.add_row(system.a.row(k), system.b.row(k));
    solution = solve_quickly(accumulator.factor());
  };
  const double seconds = seconds_of(solve);
  return {(system.a * solution - system.b).norm(), seconds};
}

bool compare(std::size_t rows) {
  const DenseSystem system = dense_system(periods_of_run(rows));
  const Timed ours = measure_accumulator(system);
  print(rows, "wheelwright, QR by blocks of rows", ours.residual, ours.seconds);
  bool met = true;
  if (OpenCvSolver theirs(system); theirs.available()) {
    const double seconds = seconds_of([&] { theirs.solve(); });
    const double residual = (system.a * theirs.solution() - system.b).norm();
    print(rows, "cv::solve, DECOMP_SVD", residual, seconds);
    met &= check(std::abs(residual - ours.residual) <= max_residual_change * residual,
                 "the same residual to 1e-9 relative");
    if (rows == 1000) met &= check(min_speed_up * ours.seconds <= seconds, "10 times faster than cv::solve");
    std::printf("        %.1f times faster\n", seconds / ours.seconds);
  }
  if (const auto octave = solve_by_octave(system)) {
    print(rows, "octave-control, arx", octave->residual_norm, octave->seconds);
  }
  return met;
}

// What the robot's loop pays: every period, and once when a new model is wanted.
bool measure_live_use() {
  const auto periods = periods_of_run(5000);
  ArmaAccumulator accumulator({order, 0});
  const double filling_s = seconds_of([&] {
    for (const auto& period : periods) accumulator.add(period.command_m_s, period.speed_m_s);
  });
  const double solving_s = seconds_of([&] { solve_quickly(accumulator.left_factor()); });
  const double report_s = seconds_of([&] { solve_small(accumulator.left_factor()); });
  std::printf(
      "\nlive use: %.2f us per period for both wheels, final solve %.4f ms per wheel (with singular "
      "values and standard errors %.4f ms)\n",
      1e6 * filling_s / static_cast<double>(periods.size()), 1e3 * solving_s, 1e3 * report_s);
  return check(solving_s < longest_final_solve_s, "final solve under 0.1 ms");
}

int run() {
  std::printf("ARMA systems of order 9: 29 unknowns of one wheel, published plant with ticks of 0.44 mm\n\n");
  std::printf("%6s  %-34s %22s %12s\n", "rows", "solver", "residual norm [m/s]", "time [ms]");
  bool met = true;
  for (const std::size_t rows : {300U, 1000U, 5000U}) met &= compare(rows);
  if (!OpenCvSolver::installed())
    std::printf("skipped: cv::solve; install libopencv-core-dev and build again\n");
  if (!octave_installed()) std::printf("skipped: arx of Octave; install octave-control\n");
  met &= measure_live_use();
  return met ? 0 : 1;
}

}  // namespace
}  // namespace wheelwright::benchmarks

int main() {
  return wheelwright::benchmarks::run();
}
