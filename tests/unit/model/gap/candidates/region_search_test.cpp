#include "model/gap/candidates/region_search.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/region_scale.hpp"
#include "model/gap/runs/run.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double wheel_base_m = 0.25;

TrialModel with_region(const std::vector<double>& region, double times = 1.0) {
  TrialModel model = first_guess({}, period_s, times * wheel_base_m, 0.06, 0.04);
  model.effects.push_back({find_effect("surface_patch"), 0, region});
  return model;
}

// Rows to and fro over two by two metres, as a robot with such a floor drives them; or all `times` as large.
GapRun driven(const TrialModel& robot, double times = 1.0) {
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = times * wheel_base_m;
  log.period_s = period_s;
  for (int k = 0; k < 6000; ++k) {
    const double time_s = period_s * k;
    const double turn = 0.1 * std::sin(0.35 * time_s) + 0.05 * std::sin(0.11 * time_s);
    DriveSample sample;
    sample.t_s = time_s;
    sample.command_m_s = {times * (0.2 - turn), times * (0.2 + turn)};
    sample.reference_x_m = simulation.pose().x_m;
    sample.reference_y_m = simulation.pose().y_m;
    sample.reference_theta_rad = simulation.pose().theta_rad;
    log.samples.push_back(sample);
    simulation.step(sample.command_m_s);
  }
  GapRun run = make_gap_run(log, {}, period_s);
  measure_motion(run);
  return run;
}

}  // namespace

TEST_CASE("A region that is placed a little off is moved, sized and turned to where it is") {
  const TrialModel truth = with_region({-0.3, 0.6, 0.5, 1.2, 0.8, 0.0});
  const FitProblem problem({driven(truth)}, {WheelPair{}}, serial_for);
  const TrialModel off = with_region({-0.3, 0.4, 0.7, 0.7, 0.7, 0.1});
  const TrialModel tuned = with_region_tuned(problem, off, serial_for);
  const auto sum_squares = [&](const TrialModel& model) { return sum_squares_of(problem.residuals(model)); };
  CHECK(sum_squares(tuned) < 0.3 * sum_squares(off));
  CHECK(tuned.effects.front().parameters.front() == -0.3);
}

TEST_CASE("A region of a large floor is tuned as one of a room") {
  constexpr double times = 6.0;
  const TrialModel truth = with_region({-0.3, 3.6, 3.0, 7.2, 4.8, 0.0}, times);
  const FitProblem problem({driven(truth, times)}, {WheelPair{}}, serial_for);
  CHECK(region_scale(problem) > 3.0);
  const TrialModel off = with_region({-0.3, 1.2, 5.4, 2.4, 2.4, 0.1}, times);
  const TrialModel tuned = with_region_tuned(problem, off, serial_for);
  const auto sum_squares = [&](const TrialModel& model) { return sum_squares_of(problem.residuals(model)); };
  CHECK(sum_squares(tuned) < 0.3 * sum_squares(off));
}

TEST_CASE("A region that reaches as far again beyond its end is cut to its size") {
  const TrialModel truth = with_region({-0.3, 3.0, -1.0, 1.0, 0.8, 0.0});
  const FitProblem problem({driven(truth)}, {WheelPair{}}, serial_for);
  const auto region = with_region_tuned(problem, with_region({-0.3, 3.5, -1.0, 2.0, 0.8, 0.0}), serial_for)
                          .effects.front()
                          .parameters;
  CHECK_THAT(region[1], WithinAbs(3.0, 0.05));
  CHECK_THAT(region[3], WithinAbs(1.0, 0.1));
}

TEST_CASE("A round region is not left as the rectangle that comes closest to it") {
  TrialModel truth = with_region({-0.3, 0.6, 0.5, 1.2, 1.2, 0.0});
  truth.effects.front().variant = variant_index(*truth.effects.front().info, "floor_round");
  const FitProblem problem({driven(truth)}, {WheelPair{}}, serial_for);
  const TrialModel off = with_region({-0.3, 0.4, 0.7, 0.7, 0.7, 0.1});
  const TrialModel tuned = with_region_tuned(problem, off, serial_for);
  const TrialEffect& region = tuned.effects.front();
  CHECK(region.info->variants[region.variant].name == "floor_round");
  const auto sum_squares = [&](const TrialModel& model) { return sum_squares_of(problem.residuals(model)); };
  CHECK(sum_squares(tuned) < 1e-3 * sum_squares(off));
}

TEST_CASE("A region that is turned round and round is given by a heading of half a turn") {
  const TrialModel truth = with_region({-0.3, 0.6, 0.5, 1.6, 0.5, 0.0});
  const FitProblem problem({driven(truth)}, {WheelPair{}}, serial_for);
  const TrialModel upright = with_region({-0.3, 0.6, 0.5, 1.6, 0.5, 1.58});
  const TrialModel tuned = with_region_tuned(problem, upright, serial_for);
  const ParameterInfo& heading = tuned.effects.front().parameter_info(5);
  CHECK(tuned.effects.front().parameters[5] >= heading.lower);
  CHECK(tuned.effects.front().parameters[5] <= heading.upper);
}

TEST_CASE("A model without a region comes back as it was") {
  const FitProblem problem({driven(with_region({-0.3, 0.6, 0.5, 1.2, 0.8, 0.0}))}, {WheelPair{}}, serial_for);
  TrialModel model = first_guess({}, period_s, wheel_base_m, 0.06, 0.04);
  CHECK_FALSE(has_region(model));
  CHECK(with_region_tuned(problem, model, serial_for).effects.empty());
}
