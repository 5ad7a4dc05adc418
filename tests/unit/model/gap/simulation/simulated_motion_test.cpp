#include "model/gap/simulation/simulated_motion.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// Straight on at this speed, by counts of a millimetre and poses.
DriveLog straight(double speed_m_s, double period_s, double seconds, double begin_s = 0.0) {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{0.001, 0.001};
  for (int k = 0; period_s * k <= seconds; ++k) {
    DriveSample sample;
    sample.t_s = begin_s + period_s * k;
    const double way_m = speed_m_s * period_s * k;
    sample.ticks = WheelTicks{std::lround(1000.0 * way_m), std::lround(1000.0 * way_m)};
    sample.reference_x_m = way_m;
    sample.reference_y_m = 0.0;
    sample.reference_theta_rad = 0.0;
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace

TEST_CASE("A simulation that does what was measured has no gap, whatever its period and start") {
  const DriveLog real[] = {straight(0.2, 0.02, 20.0)};
  const DriveLog simulated[] = {straight(0.2, 0.005, 20.0, 3.0)};
  const Score score = score_of_simulation(simulated, real);
  CHECK(*score.distance_rms_m < 0.001);
  CHECK(score.position_rms_m->value < 1e-9);
}

TEST_CASE("A simulation that is five percent fast is off by five percent of the way") {
  const DriveLog real[] = {straight(0.2, 0.02, 20.0)};
  const DriveLog simulated[] = {straight(0.21, 0.02, 20.0)};
  const Score score = score_of_simulation(simulated, real);
  REQUIRE(score.position_rms_m);
  CHECK(score.position_rms_m->horizon_s == 10.0);
  CHECK(std::abs(score.position_rms_m->value - 0.01 * 10.0) < 1e-6);
}

TEST_CASE("A simulation without counts or poses is judged by what it has") {
  const DriveLog real[] = {straight(0.2, 0.02, 20.0)};
  DriveLog poses_alone = straight(0.21, 0.02, 20.0);
  poses_alone.metres_per_tick.reset();
  for (auto& sample : poses_alone.samples) sample.ticks.reset();
  const Score by_poses = score_of_simulation(std::span(&poses_alone, 1), real);
  CHECK_FALSE(by_poses.distance_rms_m);
  CHECK(by_poses.position_rms_m);
  DriveLog counts_alone = straight(0.21, 0.02, 20.0);
  for (auto& sample : counts_alone.samples) sample.reference_x_m.reset();
  const Score by_counts = score_of_simulation(std::span(&counts_alone, 1), real);
  CHECK(by_counts.distance_rms_m);
  CHECK_FALSE(by_counts.position_rms_m);
}
