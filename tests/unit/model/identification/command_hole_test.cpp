// Ranges of commands that move nothing, and runs whose counts have another scale than the others.
#include <cmath>

#include "model/identification/command_hole.hpp"
#include "model/identification/run_scales.hpp"
#include "model/identification/speed_curve.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_log.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/wheelwright_command.hpp"

using namespace wheelwright;

namespace {

// What wheels settle at that follow their command but for a range of it.
SteadyStateSpeeds held(double from_m_s, double to_m_s, double standard_error_m_s = 0.004) {
  SteadyStateSpeeds speeds;
  for (int k = -24; k <= 24; ++k) {
    if (k == 0) continue;
    const double command = 0.01 * k;
    const bool is_still = std::abs(command) > from_m_s && std::abs(command) < to_m_s;
    (k % 2 == 0 ? speeds.left : speeds.right)
        .push_back({command, is_still ? 0.001 : 0.98 * command, standard_error_m_s, 1, 1.0});
  }
  return speeds;
}

DriveLog scaled(DriveLog log, double factor) {
  for (auto& sample : log.samples) {
    if (!sample.ticks) continue;
    sample.ticks->left = std::llround(factor * static_cast<double>(sample.ticks->left));
    sample.ticks->right = std::llround(factor * static_cast<double>(sample.ticks->right));
  }
  return log;
}

}  // namespace

TEST_CASE("A hole in the range of commands is found with its bounds, and is no steps of the speed") {
  const SteadyStateSpeeds speeds = held(0.095, 0.135);
  const auto hole = find_command_hole(speeds);
  REQUIRE(hole);
  CHECK_THAT(hole->from_m_s, WithinAbs(0.10, 1e-9));
  CHECK_THAT(hole->to_m_s, WithinAbs(0.13, 1e-9));
  CHECK_THAT(hole->moves_below_m_s, WithinAbs(0.09, 1e-9));
  CHECK_THAT(hole->moves_above_m_s, WithinAbs(0.14, 1e-9));
  CHECK_FALSE(find_speed_curve(without_hole(speeds, *hole)).steps);
}

TEST_CASE(
    "A dead zone, a wheel that stalls at high commands and speeds that are not known well are no hole") {
  CHECK_FALSE(find_command_hole(held(0.0, 0.055)));
  CHECK_FALSE(find_command_hole(held(0.195, 0.5)));
  CHECK_FALSE(find_command_hole(held(0.095, 0.135, 0.05)));
  CHECK_FALSE(find_command_hole(held(0.0, 0.0)));
}

TEST_CASE("Runs whose counts go twice as far as those of the others are named, with the factor") {
  const std::vector<DriveLog> runs{test::plant_run(1), scaled(test::plant_run(2), 2.0), test::plant_run(3)};
  const auto outlier = find_scale_outlier(runs);
  REQUIRE(outlier);
  CHECK(outlier->run == 1);
  CHECK_THAT(outlier->factor, WithinRel(2.0, 0.1));
  CHECK_FALSE(find_scale_outlier(std::vector{runs[0], runs[2]}));
  const auto of_two = find_scale_outlier(std::vector{runs[0], scaled(runs[2], 0.5)});
  REQUIRE(of_two);
  CHECK(of_two->run == 1);
  CHECK_THAT(of_two->factor, WithinRel(0.5, 0.1));
}

TEST_CASE("A run in which one wheel slips or the battery is low is no other scale") {
  DriveLog slow = scaled(test::plant_run(2), 0.8);
  DriveLog one_sided = test::plant_run(3);
  for (auto& sample : one_sided.samples) {
    if (sample.ticks) sample.ticks->left *= 2;
  }
  CHECK_FALSE(find_scale_outlier(std::vector{test::plant_run(1), slow}));
  CHECK_FALSE(find_scale_outlier(std::vector{test::plant_run(1), one_sided}));
}

TEST_CASE("A fit of real logs with a hole in the commands says the hole and no steps") {
  const auto folder = test::shared_data("logs");
  if (!folder) return;
  for (const char* name : {"38_command_hole_seed1.csv", "38_command_hole_seed2.csv"}) {
    const auto outcome = test::wheelwright_command(
        {"fit", (*folder / name).string(), "-o", (test::temporary_folder() / "hole_model.yaml").string()});
    CHECK_THAT(outcome.out, ContainsSubstring("the wheels stand still at commands of 0.10"));
    CHECK_THAT(outcome.out, !ContainsSubstring("steps of"));
  }
  const auto base = test::wheelwright_command({"fit", (*folder / "00_base.csv").string(), "-o",
                                               (test::temporary_folder() / "hole_model.yaml").string()});
  CHECK_THAT(base.out, !ContainsSubstring("stand still"));
}
