#include <cmath>
#include <random>

#include "model/gap/gap_size.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double metres_per_tick = 0.0005;
constexpr double speed_noise_m_s = 0.01;

TrialModel robot() {
  return first_guess({}, period_s, 0.25, 0.06, 0.04);
}

// At a steady command; the wheels' speeds wander, and forget after `lasts_s` where they were.
GapRun drive(double lasts_s, unsigned seed) {
  ModelSimulation simulation = robot().simulation();
  simulation.reset({});
  std::mt19937 engine(seed);
  std::normal_distribution<double> chance;
  const double kept = std::exp(-period_s / lasts_s);
  const double fresh_m_s = speed_noise_m_s * std::sqrt(1.0 - kept * kept);
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  const auto ticks = [](double way_m) { return std::llround(way_m / metres_per_tick); };
  WheelPair way_m;
  WheelPair wander_m_s;
  for (int k = 0; k < 6000; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = {0.15, 0.15};
    sample.ticks = WheelTicks{ticks(way_m.left), ticks(way_m.right)};
    log.samples.push_back(sample);
    const WheelPair speed_m_s = simulation.step(sample.command_m_s).wheel_m_s;
    wander_m_s = {kept * wander_m_s.left + fresh_m_s * chance(engine),
                  kept * wander_m_s.right + fresh_m_s * chance(engine)};
    way_m = {way_m.left + period_s * (speed_m_s.left + wander_m_s.left),
             way_m.right + period_s * (speed_m_s.right + wander_m_s.right)};
  }
  return make_gap_run(log, {}, period_s);
}

// Of the left wheel, after one second, as it is found in four drives.
double wandering_found(double lasts_s) {
  std::vector<GapRun> runs;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) runs.push_back(drive(lasts_s, seed));
  GapProblem problem(runs, std::vector<WheelPair>(runs.size(), {metres_per_tick, metres_per_tick}),
                     for_each_in_turn);
  problem.set_noise(problem.noise_left_by(robot()));
  return with_slow_noise(problem, robot()).channel[0].walk_per_sqrt_s;
}

// What such a speed comes to over a long time (Ornstein and Uhlenbeck, 1930).
double wandering_m(double lasts_s) {
  return speed_noise_m_s * std::sqrt(2.0 * lasts_s);
}

}  // namespace

TEST_CASE("Noise over seconds is as large as what wanders for a part of a second comes to") {
  for (const double lasts_s : {0.05, 0.2, 0.5}) {
    CAPTURE(lasts_s);
    CHECK_THAT(wandering_found(lasts_s), WithinRel(wandering_m(lasts_s), 0.2));
  }
}
