#include "model/identification/order_sweep.hpp"

#include "model/identification/arma_fit.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_run.hpp"

using namespace wheelwright;

namespace {

double held_out_m(const OrderSweep& sweep, std::size_t order) {
  return sweep.rows.at(order - 1).held_out_distance_rms_m;
}

}  // namespace

TEST_CASE("Of exact data of the published plant the order found is its own") {
  const DriveLog log = test::plant_run({.metres_per_tick = 1e-12});
  const auto fit = fit_arma(std::span(&log, 1), {.largest_order = 12});
  REQUIRE(fit);
  REQUIRE(fit->sweep);
  CHECK(fit->sweep->chosen == 9);
  CHECK(fit->model.left.from_own_past.size() == 9);
  CHECK(fit->sweep->rows.size() == 12);
  CHECK(held_out_m(*fit->sweep, 8) > 1000.0 * held_out_m(*fit->sweep, 9));
}

TEST_CASE("Ticks hide the last orders, so no more than the plant's own order is taken") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::vector<DriveLog> logs{
        test::plant_run({.metres_per_tick = test::create2_tick_m, .seed = seed}),
        test::plant_run({.metres_per_tick = test::create2_tick_m, .seed = seed + 10})};
    const auto fit = fit_arma(logs, {.largest_order = 12});
    REQUIRE(fit);
    const OrderSweep& sweep = *fit->sweep;
    CHECK(sweep.chosen <= 9);
    CHECK(sweep.chosen >= 4);
    const double allowed =
        std::max(held_out_m(sweep, sweep.best) + sweep.rows.at(sweep.best - 1).standard_error_m,
                 test::create2_tick_m / std::sqrt(6.0));
    CHECK(held_out_m(sweep, sweep.chosen) <= allowed);
    CHECK(held_out_m(sweep, sweep.chosen - 1) > allowed);
    CHECK(sweep.rows.at(8).multiplications == 2 * (10 + 10 + 9));
  }
}

TEST_CASE("With four runs or more, runs are the units of the standard error") {
  std::vector<DriveLog> logs;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    logs.push_back(test::plant_run({.rows = 300, .metres_per_tick = test::create2_tick_m, .seed = seed}));
  }
  const auto fit = fit_arma(logs, {.largest_order = 3});
  REQUIRE(fit);
  CHECK(fit->sweep->units == 4);
}

TEST_CASE("Orders that the data cannot carry stand in the table with the reason") {
  const DriveLog log = test::plant_run({.rows = 200, .metres_per_tick = test::create2_tick_m});
  const auto fit = fit_arma(std::span(&log, 1), {.largest_order = 15});
  REQUIRE(fit);
  CHECK_FALSE(fit->sweep->rows.front().refusal);
  REQUIRE(fit->sweep->rows.back().refusal);
  CHECK_THAT(fit->sweep->rows.back().refusal->reason, ContainsSubstring("record a longer run"));
  CHECK(fit->sweep->chosen < 12);
}

TEST_CASE("Where no order can be fitted the sweep says why") {
  const DriveLog log = test::plant_run({.rows = 15});
  const auto fit = fit_arma(std::span(&log, 1));
  REQUIRE_FALSE(fit);
  CHECK_THAT(fit.error().reason, ContainsSubstring("order 1 needs 20"));
}
