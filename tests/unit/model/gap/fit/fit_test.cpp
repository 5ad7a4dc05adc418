#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using gap::Fit;
using gap::Problem;
using gap::TrialModel;
using test::Counts;

namespace {

// To and fro in ramps, each wheel in its own time.
WheelPair to_and_fro_m_s(double time_s) {
  return {0.3 * std::clamp(1.5 * std::sin(1.1 * time_s), -1.0, 1.0),
          0.25 * std::clamp(1.5 * std::sin(0.8 * time_s + 0.5), -1.0, 1.0)};
}

}  // namespace

TEST_CASE("A parameter to which the drive is blind does not keep the others from being fitted") {
  // Where it loses its speed at 300 per second, a wheel stops at once, and whether at 250 or 300 hardly
  // shows.
  TrialModel robot = gap::first_guess({}, 0.04, 0.25, 0.1, 0.08);
  robot.effects.push_back({find_effect("backlash"), 0, {0.015, 300.0, 0.5}});
  const Problem problem = test::seen_drive(robot, 2000, to_and_fro_m_s, Counts::of_wheels);
  const double of_robot = gap::sum_squares_of(problem.residuals(robot));
  TrialModel linear = robot;
  linear.effects.clear();
  const Fit without = problem.fit(linear, 40);
  for (const double gap_m : {0.006, 0.009, 0.012, 0.02, 0.025}) {
    TrialModel start = without.model;
    start.effects.push_back({robot.effects[0].info, 0, {gap_m, 300.0, 0.5}});
    const Fit fit = problem.fit(start, 60);
    CHECK_THAT(fit.model.effects[0].parameters[0], WithinAbs(0.015, 0.0005));
    CHECK(fit.sum_squares < 1.05 * of_robot);
  }
}
