#include "model/gap/random_moments.hpp"

#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double metres_per_tick = 0.0005;
constexpr int periods = 3000;

TrialModel robot() {
  return first_guess({}, period_s, 0.25, 0.06, 0.04);
}

// Of a wheel that was held, at a few moments that nothing foretells.
struct Held {
  double loss_m = 0.0;
  double lasts_s = 0.1;
  double per_s = 0.0;
};

// Forward at two speeds by turns, as the model says but for moments and for rough ground.
GapRun drive(const Held& held, double rough_m, unsigned seed) {
  ModelSimulation simulation = robot().simulation();
  simulation.reset({});
  std::mt19937 engine(seed);
  std::normal_distribution<double> rough(0.0, rough_m);
  std::bernoulli_distribution begins(held.per_s * period_s);
  DriveLog log;
  log.name = "run" + std::to_string(seed);
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  const auto ticks = [](double way_m) { return std::llround(way_m / metres_per_tick); };
  WheelPair way_m;
  int left = 0;  // periods for which the wheel is still held
  for (int k = 0; k < periods; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    const double speed_m_s = k / 150 % 2 == 0 ? 0.2 : 0.11;
    sample.command_m_s = {speed_m_s, speed_m_s};
    sample.ticks = WheelTicks{ticks(way_m.left), ticks(way_m.right)};
    log.samples.push_back(sample);
    const WheelPair moved = simulation.step(sample.command_m_s).wheel_m_s;
    const int lasts = static_cast<int>(std::lround(held.lasts_s / period_s));
    left = left > 0 ? left - 1 : (begins(engine) ? lasts : 0);
    const double lost_m = left > 0 ? held.loss_m / lasts : 0.0;
    way_m = {way_m.left + period_s * moved.left + rough(engine) - lost_m,
             way_m.right + period_s * moved.right + rough(engine)};
  }
  return make_gap_run(log, {}, period_s);
}

std::optional<RandomMoments> moments_in(const Held& held, double rough_m = 5e-5) {
  const WheelPair scale{metres_per_tick, metres_per_tick};
  GapProblem problem({drive(held, rough_m, 1), drive(held, rough_m, 2)}, {scale, scale}, for_each_in_turn);
  problem.set_noise(problem.noise_left_by(robot()));
  return random_moments(problem, robot(), problem.residuals(robot()));
}

}  // namespace

TEST_CASE("A wheel that is held now and then is found, with the moments") {
  const auto found = moments_in({.loss_m = 0.02, .per_s = 0.05});
  REQUIRE(found);
  CHECK(found->share > 0.5);
  CHECK(found->share_of_time < 0.05);
  REQUIRE(found->moments.size() >= 3);
  for (const auto& moment : found->moments) {
    CHECK((moment.run == "run1" || moment.run == "run2"));
    CHECK(moment.time_s >= 0.0);
    CHECK(moment.time_s < period_s * periods);
  }
}

TEST_CASE("Noise that is there all the time has no moments") {
  CHECK_FALSE(moments_in({}));
  CHECK_FALSE(moments_in({}, 5e-4));
  CHECK_FALSE(moments_in({}, 0.0));
}

TEST_CASE("Slips of a millimetre, as a late clock makes them, are no such moments") {
  CHECK_FALSE(moments_in({.loss_m = 0.0015, .lasts_s = 0.02, .per_s = 0.05}, 1e-5));
}

TEST_CASE("A wheel that is held all the time is rough ground") {
  CHECK_FALSE(moments_in({.loss_m = 0.02, .lasts_s = 0.1, .per_s = 4.0}));
}
