#include "model/identification/fir_fit.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/prediction/free_run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/published_plant.hpp"

using namespace wheelwright;

namespace {

struct RunPlan {
  std::size_t rows = 1500;
  double metres_per_tick = 1e-8;
  unsigned seed = 1;
};

// A run of the paper's own plant on both wheels, with random commands that hold for some periods.
DriveLog published_plant_run(const RunPlan& plan) {
  std::mt19937 random(plan.seed);
  std::normal_distribution<double> normal(0.0, 0.2);
  test::PublishedPlant left;
  test::PublishedPlant right;
  DriveLog log;
  log.name = "plant";
  log.wheel_base_m = 0.235;
  log.period_s = 0.018;
  log.metres_per_tick = WheelPair{plan.metres_per_tick, plan.metres_per_tick};
  WheelPair travelled;
  WheelPair command;
  for (std::size_t k = 0; k < plan.rows; ++k) {
    if (k % 7 == 0) command = {normal(random), normal(random)};
    DriveSample sample;
    sample.t_s = 0.018 * static_cast<double>(k);
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled.left / plan.metres_per_tick),
                              std::llround(travelled.right / plan.metres_per_tick)};
    log.samples.push_back(sample);
    travelled.left += 0.018 * left.step(command.left);
    travelled.right += 0.018 * right.step(command.right);
  }
  return log;
}

// Three steps of each wheel, half a second long, of a wheel with a lag of 0.1 s and this gain. Some steps
// reach the robot up to 80 ms late, some readings are lost, and the robot counts every 15 ms by a clock of
// its own.
std::vector<DriveLog> short_steps(double gain, unsigned seed) {
  constexpr double metres_per_tick = 0.000444565;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<DriveLog> runs;
  for (int step = 0; step < 6; ++step) {
    DriveLog log;
    log.name = "step";
    log.wheel_base_m = 0.235;
    log.period_s = 0.018;
    log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
    const bool left = step % 2 == 0;
    const double command_m_s = 0.13 + 0.01 * step;
    const double counted_s = 0.015 * uniform(random);
    const double late_s = uniform(random) < 0.3 ? 0.08 * uniform(random) : 0.0;
    const auto travel_m = [&](double t_s) {
      const double since_s = std::max(0.0, t_s - 0.03 - late_s);
      return gain * command_m_s * (since_s - 0.1 * (1.0 - std::exp(-since_s / 0.1)));
    };
    for (int k = 0; k <= 30; ++k) {
      if (uniform(random) < 0.02) continue;
      DriveSample sample;
      sample.t_s = 0.018 * k;
      const double age_s = std::fmod(sample.t_s + counted_s, 0.015);
      const auto ticks = std::llround(travel_m(sample.t_s - age_s) / metres_per_tick);
      sample.ticks = left ? WheelTicks{ticks, 0} : WheelTicks{0, ticks};
      sample.command_m_s = left ? WheelPair{command_m_s, 0.0} : WheelPair{0.0, command_m_s};
      log.samples.push_back(sample);
    }
    runs.push_back(log);
  }
  return runs;
}

// Wheels of gain 1 that answer with a lag of the first order; their commands are held for 0.36 s.
DriveLog lagging_run(double lag_s, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 0.2);
  DriveLog log = published_plant_run({.rows = 4000});
  const double share = 1.0 - std::exp(-log.period_s / lag_s);
  WheelPair command;
  WheelPair speed;
  WheelPair travelled;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (k % 20 == 0) command = {normal(random), normal(random)};
    log.samples[k].command_m_s = command;
    log.samples[k].ticks = WheelTicks{std::llround(travelled.left / log.metres_per_tick->left),
                                      std::llround(travelled.right / log.metres_per_tick->right)};
    speed = {speed.left + share * (command.left - speed.left),
             speed.right + share * (command.right - speed.right)};
    travelled = {travelled.left + log.period_s * speed.left, travelled.right + log.period_s * speed.right};
  }
  return log;
}

}  // namespace

TEST_CASE("Steps as short as the response give its gain to a tenth, though some reach the robot late") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    const auto fit = fit_fir(short_steps(1.05, seed));
    REQUIRE(fit);
    CHECK_THAT(fit->left.gain.from_left, WithinRel(1.05, 0.1));
    CHECK_THAT(fit->right.gain.from_right, WithinRel(1.05, 0.1));
  }
}

TEST_CASE("A response longer than the search begins with is found whole, or is said to be cut") {
  // A lag of 0.4 s, read each 18 ms: 40 periods hold 83 % of the gain.
  const DriveLog log = lagging_run(0.4, 5);

  const auto whole = fit_fir(std::span(&log, 1), {.longest = 200});
  REQUIRE(whole);
  CHECK_FALSE(whole->cut);
  CHECK(whole->model.left.from_left.size() > 80);
  CHECK_THAT(whole->left.gain.from_left, WithinAbs(1.0, 2e-3));
  CHECK_THAT(whole->right.gain.from_right, WithinAbs(1.0, 2e-3));

  const auto part = fit_fir(std::span(&log, 1), {.longest = 40});
  REQUIRE(part);
  CHECK(part->cut);
}

TEST_CASE("The FIR response of the published plant is its analytic impulse response") {
  const DriveLog log = published_plant_run({});
  const auto fit = fit_fir(std::span(&log, 1));
  REQUIRE(fit);
  const auto expected = test::PublishedPlant::impulse_response(fit->model.left.from_left.size());
  CHECK(expected.size() >= 12);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("tap " << i);
    CHECK_THAT(fit->model.left.from_left[i], WithinAbs(expected[i], 5e-4));
    CHECK_THAT(fit->model.right.from_right[i], WithinAbs(expected[i], 5e-4));
    CHECK_THAT(fit->model.left.from_right[i], WithinAbs(0.0, 5e-4));
  }
  CHECK_THAT(fit->left.gain.from_left, WithinAbs(0.4108, 1e-3));
}

TEST_CASE("With a real encoder's ticks the free run on a fresh run stays within a few millimetres") {
  const DriveLog training = published_plant_run({.metres_per_tick = 0.000444565, .seed = 2});
  const DriveLog fresh = published_plant_run({.rows = 3000, .metres_per_tick = 1e-8, .seed = 3});
  const auto fit = fit_fir(std::span(&training, 1));
  REQUIRE(fit);
  const auto motion = free_run(fit->model, fresh);
  double square_sum = 0.0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double travelled = static_cast<double>(fresh.samples[k].ticks->left) * 1e-8;
    square_sum += std::pow(motion[k].distance_m.left - travelled, 2);
  }
  CHECK(std::sqrt(square_sum / static_cast<double>(motion.size())) < 0.002);
}

TEST_CASE("The stated uncertainty of the gain covers the truth") {
  int covered = 0;
  constexpr int trials = 20;
  for (unsigned seed = 100; seed < 100 + trials; ++seed) {
    const DriveLog log = published_plant_run({.rows = 600, .metres_per_tick = 0.000444565, .seed = seed});
    const auto fit = fit_fir(std::span(&log, 1));
    REQUIRE(fit);
    const double error = std::abs(fit->left.gain.from_left - test::PublishedPlant::dc_gain());
    if (error < 3.0 * fit->left.gain_standard_error.from_left + 1e-3) ++covered;
  }
  CHECK(covered >= trials - 2);
}

TEST_CASE("A fit is refused, with what is missing, where the commands cannot show the responses") {
  DriveLog log = published_plant_run({});
  const auto reason = [&] { return fit_fir(std::span(&log, 1)).error().reason; };
  for (auto& sample : log.samples) sample.command_m_s.right = sample.command_m_s.left;
  CHECK_THAT(reason(), ContainsSubstring("add a run that turns"));
  for (auto& sample : log.samples) sample.command_m_s.right = -sample.command_m_s.left;
  CHECK_THAT(reason(), ContainsSubstring("add a run that drives straight"));
  for (auto& sample : log.samples) sample.command_m_s.right = 0.0;
  CHECK_THAT(reason(), ContainsSubstring("right wheel was never driven"));
  for (auto& sample : log.samples) sample.command_m_s = {};
  CHECK_THAT(reason(), ContainsSubstring("never commanded to move"));
  log = published_plant_run({.rows = 50});
  CHECK_THAT(reason(), ContainsSubstring("record a longer run"));
  for (auto& sample : log.samples) sample.ticks.reset();
  CHECK_THAT(reason(), ContainsSubstring("no encoder counts"));
}

TEST_CASE("A gap in a log costs the samples around it and nothing else") {
  DriveLog log = published_plant_run({.rows = 2000});
  const auto whole = fit_fir(std::span(&log, 1));
  log.samples.erase(log.samples.begin() + 700, log.samples.begin() + 760);
  const auto with_gap = fit_fir(std::span(&log, 1));
  REQUIRE(whole);
  REQUIRE(with_gap);
  CHECK(with_gap->rows + 60 + 41 <= whole->rows + 1);
  CHECK_THAT(with_gap->left.gain.from_left, WithinAbs(whole->left.gain.from_left, 1e-3));
}
