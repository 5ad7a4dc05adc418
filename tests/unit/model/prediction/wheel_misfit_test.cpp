// The noise figures of a model, found from runs of a robot whose noise is known.
#include "model/prediction/wheel_misfit.hpp"

#include <cmath>
#include <random>

#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;
constexpr double metres_per_tick = 1e-6;  // so that rounding is no noise

RobotModel robot() {
  RobotModel model;
  model.linear_part.period_s = period_s;
  model.linear_part.wheel_base_m = 0.235;
  model.linear_part.left.from_left = {0.0, 0.3, 0.4, 0.3};
  model.linear_part.right.from_right = {0.0, 0.3, 0.4, 0.3};
  return model;
}

struct Noise {
  double reading_m = 0.0;
  double drift_m_per_sqrt_s = 0.0;
  double gain = 1.0;  // of the left wheel
};

WheelPair command_at(int tick) {
  const bool fast = (tick / 200) % 2 == 0;
  return fast ? WheelPair{0.2, 0.15} : WheelPair{-0.1, 0.1};
}

DriveLog run_of(const RobotModel& model, const Noise& noise, double seconds, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  ModelSimulation simulation(model);
  DriveLog log;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  WheelPair walk_m;
  const double walk_sd_m = noise.drift_m_per_sqrt_s * std::sqrt(period_s);
  const auto ticks = [&](double travel_m) {
    return std::llround((travel_m + noise.reading_m * normal(random)) / metres_per_tick);
  };
  for (int k = 0; k * period_s < seconds; ++k) {
    if (k > 0) simulation.step(command_at(k - 1));
    walk_m.left += walk_sd_m * normal(random);
    walk_m.right += walk_sd_m * normal(random);
    DriveSample sample;
    sample.t_s = k * period_s;
    sample.command_m_s = command_at(k);
    sample.ticks = WheelTicks{ticks(noise.gain * simulation.distance_m().left + walk_m.left),
                              ticks(simulation.distance_m().right + walk_m.right)};
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace

TEST_CASE(
    "The random walk between counts and model is found, whatever the noise of a reading and the gain are") {
  const RobotModel model = robot();
  for (const double drift : {0.0005, 0.002}) {
    for (const double reading_m : {0.0, 0.0005}) {
      const Noise noise{.reading_m = reading_m, .drift_m_per_sqrt_s = drift, .gain = 1.02};
      const DriveLog run = run_of(model, noise, 600.0, 1);
      const auto fits = wheel_misfit(model, std::span(&run, 1));
      REQUIRE(fits);
      CAPTURE(drift, reading_m);
      CHECK_THAT(fits->left.drift_m_per_sqrt_s, WithinRel(drift, 0.15));
      CHECK_THAT(fits->right.drift_m_per_sqrt_s, WithinRel(drift, 0.15));
    }
  }
}

TEST_CASE("A robot that stands for most of a run has the noise of its driving") {
  const RobotModel model = robot();
  DriveLog run = run_of(model, {.drift_m_per_sqrt_s = 0.001}, 300.0, 4);
  const DriveSample last = run.samples.back();
  for (int k = 1; k * period_s < 600.0; ++k) {
    DriveSample standing = last;
    standing.t_s += k * period_s;
    standing.command_m_s = {};
    run.samples.push_back(standing);
  }
  const auto fits = wheel_misfit(model, std::span(&run, 1));
  REQUIRE(fits);
  CHECK_THAT(fits->left.drift_m_per_sqrt_s, WithinRel(0.001, 0.2));
}

TEST_CASE("The standard error of the gain falls with the way that was driven") {
  const RobotModel model = robot();
  const Noise noise{.drift_m_per_sqrt_s = 0.001};
  const auto error_after = [&](double seconds) {
    const DriveLog run = run_of(model, noise, seconds, 2);
    return wheel_misfit(model, std::span(&run, 1))->left.gain_standard_error.from_left;
  };
  CHECK_THAT(error_after(100.0) / error_after(900.0), WithinRel(3.0, 0.3));
}

TEST_CASE("Runs without counts, and runs that are too short, state no noise") {
  const RobotModel model = robot();
  const DriveLog brief = run_of(model, {}, 20.0, 3);
  CHECK_FALSE(wheel_misfit(model, std::span(&brief, 1)));
  DriveLog without = run_of(model, {}, 100.0, 3);
  without.metres_per_tick.reset();
  for (DriveSample& sample : without.samples) sample.ticks.reset();
  CHECK_FALSE(wheel_misfit(model, std::span(&without, 1)));
}
