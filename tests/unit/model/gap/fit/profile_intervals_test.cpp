// Intervals where derivatives do not tell: what no reading distinguishes belongs to the interval.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "model/gap/candidates/flat_parameters.hpp"
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
FitProblem driven(const TrialModel& robot, std::span<const double> speeds_m_s, int times,
                  unsigned seed_of_errors = 1) {
  const auto command_m_s = [&](double time_s) {
    const auto half_seconds = static_cast<std::size_t>(std::lround(50.0 * time_s) / 25);
    const double speed_m_s = speeds_m_s[half_seconds % speeds_m_s.size()];
    return WheelPair{speed_m_s, speed_m_s};
  };
  const int periods = 25 * times * static_cast<int>(speeds_m_s.size());
  return test::seen_drive(robot, periods, command_m_s, test::Counts::none, seed_of_errors);
}

// The steps, and the places where they rise, by which every one of these speeds is as many steps.
std::array<ParameterInterval, 2> same_rounding(std::span<const double> speeds_m_s, double step_m_s,
                                               double rises_at) {
  const auto count = [&](double speed_m_s, double step, double rises) {
    return std::floor(std::abs(speed_m_s) / step + 1.0 - rises);
  };
  std::array same{ParameterInterval{step_m_s, step_m_s}, ParameterInterval{rises_at, rises_at}};
  for (double step = 0.95 * step_m_s; step < 1.05 * step_m_s; step += 0.0005 * step_m_s) {
    for (double rises = 0.0; rises < 1.0; rises += 0.005) {
      if (!std::ranges::all_of(speeds_m_s, [&](double speed_m_s) {
            return count(speed_m_s, step, rises) == count(speed_m_s, step_m_s, rises_at);
          }))
        continue;
      same[0] = {std::min(same[0].lower, step), std::max(same[0].upper, step)};
      same[1] = {std::min(same[1].lower, rises), std::max(same[1].upper, rises)};
    }
  }
  return same;
}

}  // namespace

TEST_CASE("All roundings that send no command elsewhere belong to the interval of where steps rise") {
  // Each is two thirds of a step beyond one: rounded up by whatever rises before that.
  constexpr std::array speeds_m_s{0.05, 0.11, 0.17, 0.23, -0.05, -0.17};
  const TrialModel robot = with_effect("command_quantization", {0.03, 0.5});
  const FitProblem problem = driven(robot, speeds_m_s, 8);
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
  const FitProblem problem = driven(robot, speeds_m_s, 15);  // ends at 1.4 m, in the region
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
  const FitProblem problem = driven(robot, speeds_m_s, 8);
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
  const FitProblem problem = driven(robot, speeds_m_s, 8);
  const Fit lost = problem.fit(with_effect("saturation", {0.2, 0.0, 0.0}), steps);
  REQUIRE(lost.model.effects.front().parameters[2] == 0.0);
  const Fit fit = away_from_flat_parameters(problem, lost, steps);
  CHECK(fit.model.effects.front().parameters[2] > 0.02);
  CHECK(fit.sum_squares < lost.sum_squares - 100.0);
}

TEST_CASE("The interval of a step and of where it rises is what rounds every command the same way") {
  std::array<double, 40> speeds_m_s{};
  for (std::size_t i = 0; i < speeds_m_s.size(); ++i)
    speeds_m_s[i] = (i % 3 == 0 ? -0.25 : 0.25) * std::fmod(0.618 * static_cast<double>(i), 1.0);
  constexpr double step_m_s = 0.0092;
  constexpr double rises_at = 0.63;
  const std::array same = same_rounding(speeds_m_s, step_m_s, rises_at);
  const TrialModel robot = with_effect("command_quantization", {step_m_s, rises_at});
  for (unsigned drive = 1; drive <= 5; ++drive) {
    const FitProblem problem = driven(robot, speeds_m_s, 1, drive);
    const Fit fit = problem.fit(with_effect("command_quantization", {0.009215, 0.612}), steps);
    const auto intervals = with_effect_intervals(problem, fit, steps, serial_for).intervals;
    REQUIRE(intervals.size() == same.size());
    for (std::size_t i = 0; i < same.size(); ++i) {
      INFO("drive " << drive << ": " << intervals[i].lower << " to " << intervals[i].upper
                    << ", the same from " << same[i].lower << " to " << same[i].upper);
      const double width = same[i].upper - same[i].lower;
      CHECK(intervals[i].lower > same[i].lower - 0.1 * width);
      CHECK(intervals[i].upper < same[i].upper + 0.1 * width);
      CHECK(intervals[i].upper - intervals[i].lower > 0.7 * width);
    }
  }
}
