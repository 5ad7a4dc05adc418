#include "model/gap/conclusion/confirmation.hpp"

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

TrialModel with_dead_zone(double threshold_m_s) {
  TrialModel robot = test::counted_robot();
  robot.effects = {{find_effect("dead_zone"), 0, {threshold_m_s, 0.002}}};
  return robot;
}

// Told this or 0.2 m/s, two seconds each.
GapRun run_at(double slow_m_s) {
  return test::counted_run(with_dead_zone(0.040), 1500, [slow_m_s](int period) {
    const double command_m_s = period / 100 % 2 == 0 ? slow_m_s : 0.2;
    return WheelPair{command_m_s, -command_m_s};
  });
}

}  // namespace

TEST_CASE("A threshold that training leaves open goes to the side of a command on which the test runs are") {
  const FitProblem train({run_at(0.030), run_at(0.060)},
                         {test::counted_metres_per_tick, test::counted_metres_per_tick}, serial_for);
  GapSearch search;
  search.final.model = with_dead_zone(0.050);
  search.intervals = {{0.031, 0.059}, {0.002, 0.002}};
  RunSet test_runs;
  test_runs.runs = {run_at(0.045)};
  test_runs.metres_per_tick = {test::counted_metres_per_tick};

  const TrialModel likeliest = likeliest_within_intervals(train, search, test_runs, serial_for);
  CHECK(likeliest.effects[0].parameters[0] < 0.045);
  CHECK(likeliest.effects[0].parameters[0] >= 0.031);

  search.intervals = {{0.049, 0.051}, {0.002, 0.002}};
  CHECK(likeliest_within_intervals(train, search, test_runs, serial_for).effects[0].parameters[0] >= 0.049);
}

TEST_CASE("A single name gains in test runs what all names gain, and a wrong one loses") {
  const auto gained = [](const TrialModel& named, double robot_threshold_m_s) {
    TrialModel robot = with_dead_zone(robot_threshold_m_s);
    const auto run = [&robot](int phase) {
      return test::counted_run(robot, 1500, [phase](int period) {
        const double command_m_s = (period + phase) / 100 % 2 == 0 ? 0.030 : 0.2;
        return WheelPair{command_m_s, -command_m_s};
      });
    };
    const FitProblem train({run(0)}, {test::counted_metres_per_tick}, serial_for);
    GapSearch search;
    search.final.model = named;
    search.baseline.model = named;
    search.baseline.model.effects.clear();
    RunSet test_runs;
    test_runs.runs = {run(50)};
    test_runs.logs.resize(1);
    test_runs.metres_per_tick = {test::counted_metres_per_tick};
    return confirm(train, search, test_runs, true, serial_for);
  };
  const Confirmation right = gained(with_dead_zone(0.040), 0.040);
  CHECK(right.gain_nats > 100.0);
  CHECK(right.gain_nats == Approx(right.effect_nats.front()).epsilon(0.01));
  CHECK(gained(with_dead_zone(0.040), 0.0).gain_nats < 0.0);
}
