#include "model/gap/candidates/fork_search.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using gap::FitProblem;
using gap::TrialModel;
using test::Counts;

namespace {

TrialModel robot_with_fork(double rate_rad_s, double trail_m, double arm_m, double lean_rad) {
  const EffectInfo* info = find_effect("caster_kick");
  TrialModel robot = gap::first_guess({}, 0.02, 0.25, 0.06, 0.04);
  robot.effects.push_back({info, variant_index(*info, "ploughing"), {rate_rad_s, trail_m, arm_m, lean_rad}});
  return robot;
}

// To and fro in curves that differ from one flip to the next.
WheelPair in_curves_m_s(double time_s) {
  const double along = 0.2 * std::sin(0.9 * time_s);
  const double turn = 0.04 * std::sin(0.37 * time_s) + 0.03 * std::sin(1.7 * time_s + 1.0);
  return {along - turn, along + turn};
}

}  // namespace

TEST_CASE("A fork that is shaped otherwise than where a fit begins is found, and not the nearest pit") {
  const TrialModel robot = robot_with_fork(0.4, 0.011, 0.06, -0.05);
  const FitProblem problem = test::seen_drive(robot, 3000, in_curves_m_s, Counts::of_wheels);
  const double of_robot = gap::sum_squares_of(problem.residuals(robot));
  const TrialModel start = robot_with_fork(0.1, 0.03, -0.1, 0.1);
  const double fitted_only = problem.fit(start, 40).sum_squares;
  const TrialModel found = with_fork_found(problem, start, gap::serial_for);
  const double found_and_fitted = problem.fit(found, 40).sum_squares;
  INFO("robot " << of_robot << ", fitted " << fitted_only << ", found " << found_and_fitted);
  CHECK(found_and_fitted < 1.05 * of_robot);
  CHECK(fitted_only > 1.2 * of_robot);
}

TEST_CASE("A fork that is right stays") {
  const TrialModel robot = robot_with_fork(0.4, 0.011, 0.06, -0.05);
  const FitProblem problem = test::seen_drive(robot, 2000, in_curves_m_s, Counts::of_wheels);
  const TrialModel found = with_fork_found(problem, robot, gap::serial_for);
  CHECK_THAT(found.effects[0].parameters[1], WithinAbs(0.011, 0.001));
  CHECK_THAT(found.effects[0].parameters[2], WithinAbs(0.06, 0.01));
}
