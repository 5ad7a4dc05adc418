// Counts that are coarse beside what a wheel goes between two readings: at a steady speed their rounding
// repeats, and is no swing of the robot.
#include <cmath>
#include <random>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double coarse_period_s = 0.02;
constexpr double wheel_base_m = 0.25;

using Draw = WheelPair (*)(std::mt19937&);

WheelPair any_speeds(std::mt19937& random) {
  std::uniform_real_distribution<double> speed_m_s(-0.1, 0.4);
  return {speed_m_s(random), speed_m_s(random)};
}

// Straight on and turns in place.
WheelPair few_speeds(std::mt19937& random) {
  constexpr double speeds_m_s[] = {0.36, 0.18, -0.36, 0.0};
  const double speed_m_s = speeds_m_s[random() % 4];
  return {speed_m_s, random() % 10 < 7 ? speed_m_s : -speed_m_s};
}

// A first-order lag of 0.15 s without any fault, counted in steps; speeds are held for seconds.
DriveLog lagging_run(double tick_m, unsigned seed, Draw draw) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> held_s(3.0, 6.0);
  DriveLog log;
  log.name = "run" + std::to_string(seed);
  log.wheel_base_m = wheel_base_m;
  log.period_s = coarse_period_s;
  log.metres_per_tick = WheelPair{tick_m, tick_m};
  WheelPair command{}, speed{}, way{};
  double until_s = 0.0;
  constexpr int steps = 20;
  for (int k = 0; k < 3000; ++k) {
    const double t_s = coarse_period_s * k;
    if (t_s >= until_s) {
      command = draw(random);
      until_s = t_s + held_s(random);
    }
    DriveSample sample;
    sample.t_s = t_s;
    sample.command_m_s = command;
    sample.ticks =
        WheelTicks{std::llround(std::floor(way.left / tick_m)), std::llround(std::floor(way.right / tick_m))};
    log.samples.push_back(sample);
    for (int i = 0; i < steps; ++i) {
      const double share = coarse_period_s / steps / 0.15;
      speed.left += share * (command.left - speed.left);
      speed.right += share * (command.right - speed.right);
      way.left += coarse_period_s / steps * speed.left;
      way.right += coarse_period_s / steps * speed.right;
    }
  }
  return log;
}

}  // namespace

TEST_CASE("Coarse counts of a sound robot are no gap, at speeds of any kind or at a few") {
  struct Case {
    double tick_m;
    Draw draw;
  };
  for (const auto& [tick_m, draw] : {Case{0.0003, any_speeds}, Case{0.006, any_speeds},
                                     Case{0.01, any_speeds}, Case{0.00578, few_speeds}}) {
    CAPTURE(tick_m);
    std::vector<DriveLog> train;
    std::vector<DriveLog> test;
    for (unsigned seed = 1; seed <= 5; ++seed)
      (seed <= 3 ? train : test).push_back(lagging_run(tick_m, seed, draw));
    const auto analysis = analyse_gap(train, test, {}, serial_for, [](const std::string&, double) {});
    REQUIRE(analysis);
    INFO(analysis->summary);
    CHECK(analysis->found.empty());
    CHECK(analysis->verdict == Verdict::nothing_missing);
  }
}
