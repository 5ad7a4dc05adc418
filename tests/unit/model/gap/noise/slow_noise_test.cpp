#include <cmath>
#include <random>

#include "model/gap/figures/free_run_figures.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using namespace wheelwright::test;

namespace {

constexpr double speed_noise_m_s = 0.01;

// At a steady command; the wheels' speeds drift, and forget after `drift_correlation_time_s` where they were.
GapRun drive(double drift_correlation_time_s, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> chance;
  const double kept = std::exp(-counted_period_s / drift_correlation_time_s);
  const double fresh_m_s = speed_noise_m_s * std::sqrt(1.0 - kept * kept);
  WheelPair drift_m_s;
  WheelPair beyond_m;
  const auto next_m = [&](double, const WheelPair&) {
    const WheelPair so_far_m = beyond_m;
    drift_m_s = {kept * drift_m_s.left + fresh_m_s * chance(engine),
                 kept * drift_m_s.right + fresh_m_s * chance(engine)};
    beyond_m.left += counted_period_s * drift_m_s.left;
    beyond_m.right += counted_period_s * drift_m_s.right;
    return so_far_m;
  };
  const auto steady = [](int) { return WheelPair{0.15, 0.15}; };
  return counted_run(counted_robot(), 6000, steady, next_m);
}

// Of the left wheel, after one second, as it is found in four drives.
double drift_found(double drift_correlation_time_s) {
  std::vector<GapRun> runs;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) runs.push_back(drive(drift_correlation_time_s, seed));
  FitProblem problem(runs, std::vector<WheelPair>(runs.size(), counted_metres_per_tick), serial_for);
  problem.set_noise(problem.noise_left_by(counted_robot()));
  return with_slow_noise(problem, counted_robot(), two_seconds_apart_s).channel[0].walk_per_sqrt_s;
}

// What such a speed comes to over a long time (Ornstein and Uhlenbeck, 1930).
double drifting_m(double drift_correlation_time_s) {
  return speed_noise_m_s * std::sqrt(2.0 * drift_correlation_time_s);
}

}  // namespace

TEST_CASE("Noise over seconds is as large as what wanders for a part of a second comes to") {
  for (const double drift_correlation_time_s : {0.05, 0.2, 0.5}) {
    CAPTURE(drift_correlation_time_s);
    CHECK_THAT(drift_found(drift_correlation_time_s), WithinRel(drifting_m(drift_correlation_time_s), 0.2));
  }
}
