#include "model/gap/regular_swing.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double metres_per_tick = 0.0005;

// What a swing adds to the travel of a wheel at a time, having come so far.
using Added = std::function<double(double time_s, double way_m)>;

double nothing(double, double) {
  return 0.0;
}

TrialModel robot() {
  return first_guess({}, period_s, 0.25, 0.06, 0.04);
}

// Forward at two speeds by turns, as the model says but for what is added and for rough ground.
GapRun drive(const Added& added, double rough_m, unsigned seed) {
  ModelSimulation simulation = robot().simulation();
  simulation.reset({});
  std::mt19937 engine(seed);
  std::normal_distribution<double> rough(0.0, rough_m);
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  WheelPair way_m;
  const auto ticks = [&](double time_s, double wheel_way_m) {
    return std::llround((wheel_way_m + added(time_s, wheel_way_m)) / metres_per_tick);
  };
  for (int k = 0; k < 2500; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    const double speed_m_s = k / 150 % 2 == 0 ? 0.2 : 0.11;
    sample.command_m_s = {speed_m_s, speed_m_s};
    sample.ticks = WheelTicks{ticks(sample.t_s, way_m.left), ticks(sample.t_s, way_m.right)};
    log.samples.push_back(sample);
    const WheelPair moved = simulation.step(sample.command_m_s).wheel_m_s;
    way_m = {way_m.left + period_s * moved.left + rough(engine),
             way_m.right + period_s * moved.right + rough(engine)};
  }
  return make_gap_run(log, {}, period_s);
}

std::optional<RegularSwing> swing_in(const Added& added, double rough_m = 2e-5) {
  const WheelPair scale{metres_per_tick, metres_per_tick};
  GapProblem problem({drive(added, rough_m, 1), drive(added, rough_m, 2)}, {scale, scale}, for_each_in_turn);
  problem.set_noise(problem.noise_left_by(robot()));
  return regular_swing(problem, robot(), problem.residuals(robot()));
}

double sine_m(double amplitude_m, double turns) {
  return amplitude_m * std::sin(2.0 * std::numbers::pi * turns);
}

}  // namespace

TEST_CASE("A hum in a robot's speed is found with its beat") {
  const auto swing = swing_in([](double time_s, double) { return sine_m(0.003, time_s / 0.44); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::time);
  CHECK_THAT(swing->period, WithinRel(0.44, 0.01));
  CHECK(swing->share > 0.3);
}

TEST_CASE("A slow pull to and fro is found with its beat") {
  const auto swing = swing_in([](double time_s, double) { return sine_m(0.03, time_s / 7.0); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::time);
  CHECK_THAT(swing->period, WithinRel(7.0, 0.08));
}

TEST_CASE("Teeth that are felt in the way of a wheel are found with their distance") {
  const auto swing = swing_in([](double, double way_m) { return sine_m(0.001, way_m / 0.036); });
  REQUIRE(swing);
  CHECK(swing->over == RegularSwing::Over::way);
  CHECK_THAT(swing->period, WithinRel(0.036, 0.01));
}

TEST_CASE("Neither rough ground nor rounding to counts keeps a beat") {
  CHECK_FALSE(swing_in(nothing));
  CHECK_FALSE(swing_in(nothing, 2e-4));
  CHECK_FALSE(swing_in(nothing, 0.0));
}
