#include "model/gap/threshold_tuning.hpp"

#include <array>
#include <cmath>

#include "model/effect_library.hpp"
#include "model/gap/gap_run.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double wheel_base_m = 0.25;

TrialModel with_effect(const char* name, const std::vector<double>& parameters) {
  TrialModel model = first_guess({}, period_s, wheel_base_m, 0.06, 0.04);
  model.effects.push_back({find_effect(name), 0, parameters});
  return model;
}

// Docking: few small speeds, each for a second and a half, and rests between them.
GapRun docking(const TrialModel& robot) {
  constexpr std::array speeds_m_s{0.009, 0.15, 0.019, -0.021, 0.027, -0.015, 0.05, -0.2, 0.023, -0.06};
  constexpr double metres_per_tick = 1e-5;
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.wheel_base_m = wheel_base_m;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  for (int k = 0; k < 3000; ++k) {
    const int part = k / 50;  // of a second
    const double speed = part % 2 == 0 ? 0.0 : speeds_m_s.at(static_cast<std::size_t>(part / 2) % 10);
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = {speed, speed};
    const WheelPair way = simulation.distance_m();
    sample.ticks =
        WheelTicks{std::llround(way.left / metres_per_tick), std::llround(way.right / metres_per_tick)};
    log.samples.push_back(sample);
    simulation.step(sample.command_m_s);
  }
  return make_gap_run(log, {}, period_s);
}

double tuned(const GapProblem& problem, const TrialModel& model, std::size_t parameter) {
  return with_thresholds_tuned(problem, model).effects.front().parameters[parameter];
}

}  // namespace

TEST_CASE("A dead zone is found between the largest command that does nothing and the next one") {
  const GapProblem problem({docking(with_effect("dead_zone", {0.02, 0.02}))}, {{1e-5, 1e-5}},
                           for_each_in_turn);
  for (const double from : {0.012, 0.03}) {
    const double threshold = tuned(problem, with_effect("dead_zone", {from, 0.02}), 0);
    CHECK(threshold > 0.019);
    CHECK(threshold < 0.021);
  }
}

TEST_CASE("A break-away is found although no slope leads from one drive that moves a wheel to the next") {
  const GapProblem problem({docking(with_effect("stiction", {0.035, 0.003, 0.03, 0.002}))}, {{1e-5, 1e-5}},
                           for_each_in_turn);
  for (const double from : {0.029, 0.043}) {
    const double excess = tuned(problem, with_effect("stiction", {from, 0.003, 0.03, 0.002}), 0);
    CHECK(excess > 0.031);
    CHECK(excess < 0.041);
  }
}

TEST_CASE("A model without a threshold stays as it is") {
  const TrialModel truth = with_effect("coulomb_friction", {0.01, 0.03});
  const GapProblem problem({docking(truth)}, {{1e-5, 1e-5}}, for_each_in_turn);
  const TrialModel model = with_effect("coulomb_friction", {0.02, 0.03});
  CHECK(with_thresholds_tuned(problem, model).effects.front().parameters == model.effects.front().parameters);
}
