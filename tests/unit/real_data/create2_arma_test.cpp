// ARMA models of a real Create 2, where its logs are.
#include "config/load/drive_log_file.hpp"
#include "model/identification/arma_fit.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/create2_logs.hpp"

using namespace wheelwright;

TEST_CASE("Order 9 of one run of a Create 2, run free over the repeat, stays within 1 mm for 33 s") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const DriveLog training = config::load_drive_log(*folder / "run1.csv");
  const DriveLog repeat = config::load_drive_log(*folder / "run2.csv");
  const auto fit = fit_arma(std::span(&training, 1), {.order = 9});
  REQUIRE(fit);
  CHECK(repeat.samples.back().t_s > 32.0);
  CHECK(*score_run(free_run(fit->model, repeat), repeat).distance_rms_m <= 0.001);
  CHECK(fit->left.largest_pole < 0.9);
  CHECK(fit->left.condition > 144.0);  // 144 to 2630 on real order-9 regressors
  CHECK(fit->left.condition < 2630.0);
}

TEST_CASE("The free run of eq. (12) on differenced counts of a Create 2 is worse than of the refined fit") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const DriveLog training = config::load_drive_log(*folder / "run1.csv");
  const DriveLog repeat = config::load_drive_log(*folder / "run2.csv");
  const auto plain = fit_arma(std::span(&training, 1), {.order = 9, .method = ArmaMethod::equation_error});
  const auto refined = fit_arma(std::span(&training, 1), {.order = 9});
  REQUIRE(plain);
  REQUIRE(refined);
  CHECK(plain->left.one_step_rms_m_s < refined->left.one_step_rms_m_s);  // one step says the opposite
  CHECK(*score_run(free_run(refined->model, repeat), repeat).distance_rms_m <
        0.6 * *score_run(free_run(plain->model, repeat), repeat).distance_rms_m);
}

TEST_CASE("No order of a linear model fits the concave speed curve of a Create 2") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  for (const std::string name : {"speeds_1a.csv", "speeds_2a.csv"}) {
    INFO(name);
    const auto runs = config::load_drive_logs(*folder / name);
    const auto small = fit_arma(runs, {.order = 2});
    const auto large = fit_arma(runs, {.order = 9});
    REQUIRE(small);
    REQUIRE(large);
    CHECK(large->free_run_distance_rms_m > 0.01);  // where run 1 leaves 0.0006
    CHECK(large->free_run_distance_rms_m > 0.8 * small->free_run_distance_rms_m);
  }
}
