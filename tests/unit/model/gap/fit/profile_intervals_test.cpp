// Intervals where derivatives do not tell: what no reading distinguishes belongs to the interval.
#include <array>
#include <cmath>
#include <span>

#include "model/gap/candidates/flat_places.hpp"
#include "model/gap/fit/parameter_intervals.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr int steps = 15;

TrialModel with_effect(const std::string& name, const std::vector<double>& parameters) {
  LinearPartShape one_gain;
  one_gain.shared = true;
  return test::robot_with(name, parameters, one_gain);
}

// Straight on, one speed after the other, half a second each.
Problem driven(const TrialModel& robot, std::span<const double> speeds_m_s, int times) {
  const auto command_m_s = [&](double time_s) {
    const auto half_seconds = static_cast<std::size_t>(std::lround(50.0 * time_s) / 25);
    const double speed_m_s = speeds_m_s[half_seconds % speeds_m_s.size()];
    return WheelPair{speed_m_s, speed_m_s};
  };
  const int periods = 25 * times * static_cast<int>(speeds_m_s.size());
  return test::seen_drive(robot, periods, command_m_s, test::Counts::none);
}

}  // namespace

TEST_CASE("All roundings that send no command elsewhere belong to the interval of where steps rise") {
  // Each is two thirds of a step beyond one: rounded up by whatever rises before that.
  constexpr std::array speeds_m_s{0.05, 0.11, 0.17, 0.23, -0.05, -0.17};
  const TrialModel robot = with_effect("command_quantization", {0.03, 0.5});
  const Problem problem = driven(robot, speeds_m_s, 8);
  const auto intervals =
      with_effect_intervals(problem, problem.fit(robot, steps), steps, serial_for).intervals;
  REQUIRE(intervals.size() == 2);
  CHECK(intervals[1].lower < 0.05);
  CHECK(intervals[1].upper > 0.66);
  CHECK(intervals[1].upper < 0.75);
}

TEST_CASE("How far a region reaches behind the place where the robot stopped is not claimed") {
  constexpr std::array speeds_m_s{0.2};
  enum : std::size_t { change, x, y, length, width, heading };
  const TrialModel robot = with_effect("surface_patch", {-0.2, 1.6, 0.0, 1.2, 1.0, 0.0});
  const Problem problem = driven(robot, speeds_m_s, 15);  // ends at 1.4 m, in the region
  const auto intervals =
      with_effect_intervals(problem, problem.fit(robot, steps), steps, serial_for).intervals;
  const auto info = [&](std::size_t i) { return robot.effects.front().parameter_info(i); };
  CHECK(intervals[length].lower < 0.5);
  CHECK(intervals[length].upper > 10.0);
  CHECK(intervals[width].upper == info(width).upper);
  CHECK(intervals[change].upper - intervals[change].lower < 0.01);
}

TEST_CASE("Where the likelihood is a parabola, its profile widens an interval by little") {
  constexpr std::array speeds_m_s{0.05, 0.2, 0.11, -0.2, 0.15};
  const TrialModel robot = with_effect("direction_gain", {-0.05});
  const Problem problem = driven(robot, speeds_m_s, 8);
  const Fit fit = problem.fit(robot, steps);
  const auto linear = linear_intervals(problem, problem.jacobian(fit.model, fit.residuals), fit.residuals);
  const auto intervals = with_effect_intervals(problem, fit, steps, serial_for).intervals;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const ParameterInterval& by_slope = linear[fit.model.linear_part.size() + i].deviation;
    const double width = intervals[i].upper - intervals[i].lower;
    CHECK(width >= 0.99 * (by_slope.upper - by_slope.lower));
    CHECK(width < 1.4 * (by_slope.upper - by_slope.lower));
  }
}

TEST_CASE("A knee that a fit has lost at zero, where it has no slope, is found again") {
  constexpr std::array speeds_m_s{0.1, 0.2, 0.15, 0.25, 0.05, 0.3};
  const TrialModel robot = with_effect("saturation", {0.22, 0.0, 0.15});
  const Problem problem = driven(robot, speeds_m_s, 8);
  const Fit lost = problem.fit(with_effect("saturation", {0.2, 0.0, 0.0}), steps);
  REQUIRE(lost.model.effects.front().parameters[2] == 0.0);
  const Fit fit = away_from_flat_places(problem, lost, steps);
  CHECK(fit.model.effects.front().parameters[2] > 0.02);
  CHECK(fit.sum_squares < lost.sum_squares - 100.0);
}
