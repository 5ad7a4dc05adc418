#include "model/gap/candidates/threshold_search.hpp"

#include <array>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

TrialModel with_effect(const char* name, const std::vector<double>& parameters) {
  TrialModel model = test::counted_robot();
  model.effects.push_back({find_effect(name), 0, parameters});
  return model;
}

// Few small speeds, each for a second, and rests between them.
WheelPair docking(int period) {
  constexpr std::array speeds_m_s{0.009, 0.15, 0.019, -0.021, 0.027, -0.015, 0.05, -0.2, 0.023, -0.06};
  const int second = period / 50;
  const double speed = second % 2 == 0 ? 0.0 : speeds_m_s.at(static_cast<std::size_t>(second / 2) % 10);
  return {speed, speed};
}

FitProblem docked(const TrialModel& robot) {
  return {{test::counted_run(robot, 3000, docking)}, {test::counted_metres_per_tick}, serial_for};
}

double tuned(const FitProblem& problem, const TrialModel& model, std::size_t parameter) {
  return with_thresholds_tuned(problem, model).effects.front().parameters[parameter];
}

}  // namespace

TEST_CASE("A dead zone is found between the largest command that does nothing and the next one") {
  const FitProblem problem = docked(with_effect("dead_zone", {0.02, 0.02}));
  for (const double from : {0.012, 0.03}) {
    const double threshold = tuned(problem, with_effect("dead_zone", {from, 0.02}), 0);
    CHECK(threshold > 0.019);
    CHECK(threshold < 0.021);
  }
}

TEST_CASE("Firmware that passes larger commands whole is a step, whatever taper the fit is at") {
  const FitProblem problem = docked(with_effect("dead_zone", {0.0205, 0.002}));
  for (const double taper : {0.14, 1.0}) {
    INFO(taper);
    const TrialModel start = with_effect("dead_zone", {0.018, taper});
    CHECK_THAT(tuned(problem, start, 0), WithinAbs(0.02, 0.001));
    CHECK_THAT(tuned(problem, start, 1), WithinAbs(0.002, 1e-9));
  }
}

TEST_CASE("A break-away is found although no slope leads from one drive that moves a wheel to the next") {
  const FitProblem problem = docked(with_effect("stiction", {0.035, 0.003, 0.03, 0.002}));
  for (const double from : {0.029, 0.043}) {
    const double excess = tuned(problem, with_effect("stiction", {from, 0.003, 0.03, 0.002}), 0);
    CHECK(excess > 0.031);
    CHECK(excess < 0.041);
  }
}

TEST_CASE("A model without a threshold stays as it is") {
  const TrialModel truth = with_effect("coulomb_friction", {0.01, 0.03});
  const FitProblem problem = docked(truth);
  const TrialModel model = with_effect("coulomb_friction", {0.02, 0.03});
  CHECK(with_thresholds_tuned(problem, model).effects.front().parameters == model.effects.front().parameters);
}
