#include "model/identification/arma_fit.hpp"

#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/plant_run.hpp"

using namespace wheelwright;

namespace {

// Largest difference of any weight of a wheel that answers as the published plant to its own motor.
double distance_from_plant(const WheelResponse& response, const std::vector<double>& own,
                           const std::vector<double>& other) {
  double largest = 0.0;
  const auto& inputs = test::PublishedPlant::input_weights;
  const auto& outputs = test::PublishedPlant::output_weights;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double expected = i >= 1 && i <= inputs.size() ? inputs[i - 1] : 0.0;
    largest = std::max({largest, std::abs(own[i] - expected), std::abs(other[i])});
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    largest = std::max(largest, std::abs(response.from_own_past[i] - outputs[i]));
  }
  return largest;
}

double distance_from_plant(const LinearModel& model) {
  return std::max(distance_from_plant(model.left, model.left.from_left, model.left.from_right),
                  distance_from_plant(model.right, model.right.from_right, model.right.from_left));
}

// RMS of the free-run speed of the left wheel against the plant itself, on fresh random commands, relative to
// the RMS of the plant's speed.
double relative_free_run_error(const LinearModel& model, unsigned seed) {
  LinearPredictor predictor(model);
  test::PublishedPlant plant;
  double error = 0.0;
  double whole = 0.0;
  for (const auto& sample : test::plant_run({.rows = 3000, .seed = seed}).samples) {
    const double truth = plant.step(sample.command_m_s.left);
    const double predicted = predictor.step(sample.command_m_s).left;
    error += (predicted - truth) * (predicted - truth);
    whole += truth * truth;
  }
  return std::sqrt(error / whole);
}

std::string reason_of(const DriveLog& log, const ArmaFitOptions& options = {.order = 9}) {
  const auto fit = fit_arma(std::span(&log, 1), options);
  return fit ? "no refusal" : fit.error().reason;
}

}  // namespace

TEST_CASE("The published plant is recovered from 1000 noise-free rows") {
  const DriveLog log = test::plant_run({.rows = 1000});
  for (const ArmaMethod method : {ArmaMethod::equation_error, ArmaMethod::free_run}) {
    const auto fit = fit_arma(std::span(&log, 1), {.order = 9, .method = method});
    REQUIRE(fit);
    CHECK(distance_from_plant(fit->model) < 1e-8);
    CHECK(fit->rows == 999);
    CHECK(fit->left.rank == 29);
    CHECK(fit->left.condition < 1e4);
    CHECK_THAT(fit->left.largest_pole, WithinAbs(0.78, 0.01));
    CHECK_THAT(fit->left.quality.gain.from_left, WithinAbs(0.4108, 1e-4));
    CHECK(relative_free_run_error(fit->model, 50) < 1e-8);
  }
}

TEST_CASE("With a real encoder's ticks the free run stays within a tenth of the noise-free one") {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    INFO("seed " << seed);
    const DriveLog log =
        test::plant_run({.rows = 1000, .metres_per_tick = test::create2_tick_m, .seed = seed});
    const auto fit = fit_arma(std::span(&log, 1), {.order = 9});
    REQUIRE(fit);
    CHECK(relative_free_run_error(fit->model, 100 + seed) < 0.1);
    CHECK_THAT(fit->left.quality.gain.from_left, WithinAbs(0.4108, 5e-4));
    // Rounding to whole ticks, in distance.
    CHECK_THAT(fit->left.quality.position_noise_m, WithinRel(test::create2_tick_m / std::sqrt(12.0), 0.05));
  }
}

TEST_CASE("Fitting the free run beats fitting differences of counts") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const DriveLog log =
        test::plant_run({.rows = 3000, .metres_per_tick = test::create2_tick_m, .seed = seed});
    const auto biased = fit_arma(std::span(&log, 1), {.order = 9, .method = ArmaMethod::equation_error});
    const auto refined = fit_arma(std::span(&log, 1), {.order = 9});
    REQUIRE(biased);
    REQUIRE(refined);
    CHECK(2.0 * relative_free_run_error(refined->model, 60) < relative_free_run_error(biased->model, 60));
    CHECK(5.0 * std::abs(refined->left.quality.gain.from_left - test::PublishedPlant::dc_gain()) <
          std::abs(biased->left.quality.gain.from_left - test::PublishedPlant::dc_gain()));
  }
}

TEST_CASE("A log off the model's grid is read at its real times") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  DriveLog log = test::plant_run({.rows = 3000, .hold = 5});
  // Readings move along the straight line between two of them; commands change where they did.
  DriveLog irregular = log;
  irregular.samples.clear();
  for (std::size_t k = 0; k + 1 < log.samples.size(); ++k) {
    irregular.samples.push_back(log.samples[k]);
    const double share = 0.5 + jitter(random);
    DriveSample between = log.samples[k];
    between.t_s += share * 0.018;
    const auto& next = *log.samples[k + 1].ticks;
    between.ticks->left += std::llround(share * static_cast<double>(next.left - between.ticks->left));
    between.ticks->right += std::llround(share * static_cast<double>(next.right - between.ticks->right));
    irregular.samples.push_back(between);
  }
  const auto fit = fit_arma(std::span(&irregular, 1), {.order = 9});
  REQUIRE(fit);
  CHECK(distance_from_plant(fit->model) < 1e-7);
}

TEST_CASE("A gap costs the rows whose past it hides and nothing else") {
  DriveLog log = test::plant_run({.rows = 2000});
  log.samples.erase(log.samples.begin() + 700, log.samples.begin() + 760);
  const auto fit = fit_arma(std::span(&log, 1), {.order = 9, .method = ArmaMethod::equation_error});
  REQUIRE(fit);
  CHECK(fit->rows == 1999 - 61 - 9);
  CHECK(distance_from_plant(fit->model) < 1e-8);
  const auto refined = fit_arma(std::span(&log, 1), {.order = 9});
  REQUIRE(refined);
  // Commands within the gap are not known; a second later they have faded to this.
  CHECK(distance_from_plant(refined->model) < 1e-6);
}

TEST_CASE("A fixed delay leaves the leading weights at zero") {
  const DriveLog log = test::plant_run({.metres_per_tick = test::create2_tick_m});
  const auto fit = fit_arma(std::span(&log, 1), {.order = 9, .delay = 3});
  REQUIRE(fit);
  CHECK(fit->left.unknowns == 2 * 7 + 9);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(fit->model.left.from_left[i] == 0.0);
    CHECK(fit->model.left.from_right[i] == 0.0);
  }
  CHECK(fit->model.left.from_left[3] != 0.0);
  CHECK(fit->model.left.from_left.size() == 10);
}

TEST_CASE("The stated error of the gain covers the truth") {
  int covered = 0;
  constexpr int trials = 20;
  for (unsigned seed = 200; seed < 200 + trials; ++seed) {
    const DriveLog log =
        test::plant_run({.rows = 1000, .metres_per_tick = test::create2_tick_m, .seed = seed});
    const auto fit = fit_arma(std::span(&log, 1), {.order = 9});
    REQUIRE(fit);
    const double error = std::abs(fit->left.quality.gain.from_left - test::PublishedPlant::dc_gain());
    if (error < 3.0 * fit->left.quality.gain_standard_error.from_left) ++covered;
  }
  CHECK(covered >= trials - 3);
}

TEST_CASE("An ARMA fit is refused, with what is missing, where the data cannot show it") {
  DriveLog log = test::plant_run({});
  for (auto& sample : log.samples) sample.command_m_s.right = sample.command_m_s.left;
  CHECK_THAT(reason_of(log), ContainsSubstring("add a run that turns"));
  for (auto& sample : log.samples) sample.command_m_s = {};
  CHECK_THAT(reason_of(log), ContainsSubstring("never commanded to move"));
  log = test::plant_run({.rows = 100});
  CHECK_THAT(reason_of(log), ContainsSubstring("needs 116; record a longer run, or fit a lower order"));
  log = test::plant_run({});
  log.samples[17].command_m_s.left = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(reason_of(log), ContainsSubstring("row 18 is not a number; delete the row"));
  for (auto& sample : log.samples) sample.ticks.reset();
  CHECK_THAT(reason_of(log), ContainsSubstring("no encoder counts"));
}

TEST_CASE("Commands whose changes all fall into gaps cannot tell the weights apart") {
  std::vector<DriveLog> logs;
  for (const WheelPair command : {WheelPair{0.2, 0.1}, WheelPair{0.1, -0.2}}) {
    DriveLog log = test::plant_run({.rows = 400});
    for (std::size_t k = 0; k < log.samples.size(); ++k) {
      log.samples[k].command_m_s = k < 30 ? WheelPair{} : command;
    }
    log.samples.erase(log.samples.begin() + 28, log.samples.begin() + 60);
    logs.push_back(log);
  }
  const auto fit = fit_arma(logs, {.order = 9});
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason, ContainsSubstring("record a run whose commands change at random"));
}

TEST_CASE("Runs of other robots or other periods are not fitted together") {
  std::vector<DriveLog> logs{test::plant_run({.seed = 1}), test::plant_run({.seed = 2})};
  logs[1].wheel_base_m = 0.33;
  CHECK_THAT(fit_arma(logs, {.order = 9}).error().reason,
             ContainsSubstring("fit runs of one robot together"));
  logs[1].wheel_base_m = logs[0].wheel_base_m;
  logs[1].period_s = 0.05;
  CHECK_THAT(fit_arma(logs, {.order = 9}).error().reason, ContainsSubstring("its period is 0.05 s"));
}

TEST_CASE("A wheel that runs away is refused as that") {
  DriveLog log = test::plant_run({.metres_per_tick = 1e-9});
  double left = 0.0;
  double speed = 0.0;
  for (auto& sample : log.samples) {
    sample.ticks->left = std::llround(left * 1e9);
    speed = 1.004 * speed + 0.01 * sample.command_m_s.left;
    left += 0.018 * speed;
  }
  for (const ArmaMethod method : {ArmaMethod::equation_error, ArmaMethod::free_run}) {
    CHECK_THAT(reason_of(log, {.order = 2, .method = method}), ContainsSubstring("longer run"));
  }
}
