#include "model/identification/arma_accumulator.hpp"

#include "model/identification/least_squares_solution.hpp"
#include "model/log/run_periods.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_run.hpp"

using namespace wheelwright;

TEST_CASE("The quick solution of a live fit is that of the singular values") {
  ArmaAccumulator accumulator({9, 0});
  const DriveLog log = test::plant_run({.metres_per_tick = test::create2_tick_m});
  for_each_period(log, log.period_s,
                  [&](const RunPeriod& period) { accumulator.add(period.command_m_s, period.speed_m_s); });
  const auto factor = accumulator.left_factor();
  const SmallSolution whole = solve_small(factor);
  CHECK((solve_quickly(factor) - whole.unknowns).norm() < 1e-11 * whole.unknowns.norm());
  CHECK_THAT(whole.residual_variance * static_cast<double>(factor.rows - whole.rank),
             WithinRel(residual_square_sum(factor, whole.unknowns), 1e-9));
}

TEST_CASE("After its past is lost an accumulator waits until the rows know theirs") {
  ArmaAccumulator accumulator({3, 0});
  accumulator.add({0.1, 0.2}, WheelPair{0.1, 0.2});
  CHECK(accumulator.rows() == 1);  // a run begins with a robot at rest
  accumulator.lose_past();
  for (int k = 0; k < 3; ++k) accumulator.add({0.1, 0.2}, WheelPair{0.1, 0.2});
  CHECK(accumulator.rows() == 1);
  accumulator.add({0.1, 0.2}, WheelPair{0.1, 0.2});
  CHECK(accumulator.rows() == 2);
  accumulator.add({0.1, 0.2}, std::nullopt);
  for (int k = 0; k < 3; ++k) accumulator.add({0.1, 0.2}, WheelPair{0.1, 0.2});
  CHECK(accumulator.rows() == 2);
}
