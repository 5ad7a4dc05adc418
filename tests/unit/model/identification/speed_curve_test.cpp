// What fits find of bent curves and steps in the settled speeds of runs that have them, or have not.
#include "model/identification/speed_curve.hpp"

#include <cmath>

#include "config/load/drive_log_file.hpp"
#include "model/identification/fir_fit.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/create2_logs.hpp"
#include "tests/support/plant_log.hpp"

using namespace wheelwright;

namespace {

SteadyStateSpeeds speeds_of(std::span<const DriveLog> logs) {
  const auto fit = fit_fir(logs);
  REQUIRE(fit);
  return steady_state_speeds(logs, fit->model, fit->left, fit->right);
}

SpeedCurve curve_of(const DriveLog& log) {
  return find_speed_curve(speeds_of(std::span(&log, 1)));
}

constexpr std::size_t rows = 3000;
constexpr std::size_t rows_per_command = 30;

double in_steps(double command) {
  constexpr double step_m_s = 0.0285;
  return step_m_s * std::round(command / step_m_s);
}

double concave(double command) {
  return command * (1.0 - 0.8 * std::abs(command));
}

}  // namespace

TEST_CASE("Held commands show the speeds at which the wheels settle") {
  const DriveLog log = test::plant_run(1, rows, nullptr, rows_per_command);
  const SteadyStateSpeeds speeds = speeds_of(std::span(&log, 1));
  REQUIRE(speeds.left.size() + 2 >= rows / rows_per_command);  // two commands may be alike by chance
  std::size_t within = 0;
  for (const auto& speed : speeds.left) {
    const double error = speed.speed_m_s - test::PublishedPlant::dc_gain() * speed.command_m_s;
    if (std::abs(error) < 2.0 * speed.standard_error_m_s) ++within;
    CHECK(std::abs(error) < 0.006);  // three counts in the sixteen periods of a hold are 4.6 mm/s
  }
  CHECK(within >= 90);
}

TEST_CASE("A linear robot is not said to have a bent curve or steps") {
  constexpr unsigned runs = 40;
  unsigned bends = 0;
  unsigned steps = 0;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    const SpeedCurve curve = curve_of(test::plant_run(seed, rows, nullptr, rows_per_command));
    bends += curve.bend ? 1U : 0U;
    steps += curve.steps ? 1U : 0U;
  }
  CHECK(bends == 0);
  CHECK(steps <= 1);  // by chance in one of a hundred
}

TEST_CASE("Steps are found with their size, and not where a curve is smooth") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const SpeedCurve curve = curve_of(test::plant_run(seed, rows, in_steps, rows_per_command));
    REQUIRE(curve.steps);
    CHECK(curve.steps->step_m_s == Approx(0.0285).margin(0.001));
    CHECK(curve.steps->smallest_m_s <= curve.steps->step_m_s);
    CHECK(curve.steps->largest_m_s >= curve.steps->step_m_s);
    CHECK_FALSE(curve_of(test::plant_run(seed, rows, concave, rows_per_command)).steps);
  }
}

TEST_CASE("A concave curve is told by its gain at small and at large commands") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const SpeedCurve curve = curve_of(test::plant_run(seed, rows, concave, rows_per_command));
    REQUIRE(curve.bend);
    const auto expected = [](const GainAt& at) {
      return test::PublishedPlant::dc_gain() * (1.0 - 0.8 * at.command_m_s);
    };
    CHECK(curve.bend->low.gain == Approx(expected(curve.bend->low)).margin(0.03));
    CHECK(curve.bend->high.gain == Approx(expected(curve.bend->high)).margin(0.03));
    CHECK(curve.bend->low.gain > 1.1 * curve.bend->high.gain);
  }
}

TEST_CASE("Too few held commands show neither") {
  DriveLog log = test::plant_run(1, rows, concave, rows_per_command);
  for (auto& sample : log.samples) {
    sample.command_m_s.left = sample.command_m_s.left < 0.0 ? -0.1 : 0.1;
    sample.command_m_s.right = sample.command_m_s.right < 0.0 ? -0.1 : 0.1;
  }
  const SpeedCurve curve = curve_of(log);
  CHECK(curve.commands == 1);
  CHECK_FALSE(curve.bend);
  CHECK_FALSE(curve.steps);
}

TEST_CASE("A hole in the rows ends a hold") {
  DriveLog log = test::plant_run(1, rows, nullptr, rows_per_command);
  const std::size_t whole = speeds_of(std::span(&log, 1)).left.size();
  // From the middle of one hold to the middle of the next: what is left of both is too short.
  log.samples.erase(log.samples.begin() + 1215, log.samples.begin() + 1245);
  CHECK(speeds_of(std::span(&log, 1)).left.size() == whole - 2);
}

TEST_CASE("A real Create 2 goes in steps along a concave curve") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  for (const char* name : {"speeds_1a.csv", "speeds_2a.csv"}) {
    INFO(name);
    const SpeedCurve curve = find_speed_curve(speeds_of(config::load_drive_logs(*folder / name)));
    REQUIRE(curve.bend);
    CHECK(curve.bend->low.gain > curve.bend->high.gain + 0.2);
    REQUIRE(curve.steps);
    CHECK(curve.steps->smallest_m_s < 0.02845);  // one count per 15.625 ms
    CHECK(curve.steps->largest_m_s > 0.02845);
  }
}
