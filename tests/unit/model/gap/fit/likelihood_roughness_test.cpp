// What a likelihood is beside a parabola: nothing where models are smooth, steps where commands are rounded.
#include <cmath>

#include "model/gap/fit/likelihood_roughness.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/seen_drive.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;
using test::Counts;
using test::robot_with;

namespace {

WheelPair swing_m_s(double t_s) {
  return {0.06 * std::sin(2.5 * t_s), 0.048 * std::sin(2.5 * (t_s + 0.4))};
}

double roughness_of(const TrialModel& robot) {
  const FitProblem problem = test::seen_drive(robot, 3000, swing_m_s, Counts::of_wheels);
  const Fit fit = problem.fit(robot, 15);
  return likelihood_roughness(problem, fit, problem.jacobian(fit.model, fit.residuals));
}

}  // namespace

TEST_CASE("A smooth likelihood has no roughness") {
  CHECK(roughness_of(robot_with("direction_gain", {-0.05})) < 0.1);
  CHECK(roughness_of(robot_with("gain_curve", {0.1, 0.1})) < 0.1);
}

TEST_CASE("The likelihood of wheels that stick and slip is rough") {
  CHECK(roughness_of(robot_with("stiction", {0.02, 0.008, 0.03, 0.004})) > 0.5);
}
