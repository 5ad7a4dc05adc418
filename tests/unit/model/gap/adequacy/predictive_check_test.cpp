// The predictive check on whole analyses: a gap that anybody sees in a plot is not called noise.
#include <cmath>
#include <numbers>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> clean_runs(std::uint64_t seed) {
  test::GapCaseSpec spec;
  spec.name = "clean";
  spec.seed = seed;
  spec.runs = 3;
  spec.seconds = 28.0;
  spec.period_s = 0.03;
  return test::make_gap_case(spec).runs;
}

GapAnalysis analysed(const std::vector<DriveLog>& runs) {
  const std::span<const DriveLog> all(runs);
  auto analysis =
      analyse_gap(all.first(2), all.subspan(2), {}, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

// The heading that is measured swings while the robot drives.
void add_swing(std::vector<DriveLog>& runs, double amplitude_rad, double period_s) {
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      const bool drives = std::abs(sample.command_m_s.left) + std::abs(sample.command_m_s.right) > 0.01;
      if (!sample.reference_theta_rad || !drives) continue;
      *sample.reference_theta_rad += amplitude_rad * std::sin(2.0 * std::numbers::pi * sample.t_s / period_s);
    }
  }
}

// The wheels swing against each other while the robot drives, and the heading with them.
void add_hunting(std::vector<DriveLog>& runs, double amplitude_m, double period_s) {
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      const bool drives = std::abs(sample.command_m_s.left) + std::abs(sample.command_m_s.right) > 0.01;
      if (!sample.ticks || !drives) continue;
      const double swing_m = amplitude_m * std::sin(2.0 * std::numbers::pi * sample.t_s / period_s);
      sample.ticks->left += std::lround(swing_m / run.metres_per_tick->left);
      sample.ticks->right -= std::lround(swing_m / run.metres_per_tick->right);
      if (sample.reference_theta_rad) *sample.reference_theta_rad -= 2.0 * swing_m / run.wheel_base_m;
    }
  }
}

}  // namespace

TEST_CASE("A robot of which nothing is missing passes the predictive check") {
  const auto analysis = analysed(clean_runs(41));
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK(analysis.check.passed);
  CHECK_FALSE(analysis.check.statistics.empty());
}

TEST_CASE("A heading that swings while driving is unnamed, and the sentence gives period and size") {
  constexpr double amplitude_rad = 0.020;
  auto runs = clean_runs(42);
  add_swing(runs, amplitude_rad, 1.43);
  const auto analysis = analysed(runs);
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::unnamed);
  CHECK_FALSE(analysis.check.passed);
  const CheckStatistic& first = analysis.check.statistics.front();
  CHECK(first.name == "periodic residual, heading");
  REQUIRE(first.detail.front().first == "period_s");
  CHECK_THAT(first.detail.front().second, WithinRel(1.43, 0.02));
  CHECK_THAT(first.size, WithinRel(amplitude_rad, 0.4));
  CHECK_THAT(analysis.summary, ContainsSubstring("the error of the heading swings every 1.4"));
}

TEST_CASE("Wheels that swing against each other by a millimetre are seen by the heading that they turn by") {
  auto runs = clean_runs(42);
  add_hunting(runs, 0.0012, 0.77);
  const auto analysis = analysed(runs);
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::unnamed);
  const CheckStatistic& first = analysis.check.statistics.front();
  REQUIRE(first.detail.front().first == "period_s");
  CHECK_THAT(first.detail.front().second, WithinRel(0.77, 0.02));
  REQUIRE(first.detail.back().first == "heading_amplitude_rad");
  CHECK_THAT(first.detail.back().second, WithinRel(2.0 * 0.0012 / runs.front().wheel_base_m, 0.15));
  CHECK_THAT(analysis.summary, ContainsSubstring("the heading, by the wheels, swings every"));
}

TEST_CASE(
    "A compass beside iron is unnamed, and the sentence says how far and how often it is off in a turn") {
  auto runs = clean_runs(43);
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      if (sample.reference_theta_rad)
        *sample.reference_theta_rad += 0.05 * std::sin(2.0 * *sample.reference_theta_rad + 0.4);
    }
  }
  const auto analysis = analysed(runs);
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::unnamed);
  CHECK(analysis.check.statistics.front().name == "offset over heading, heading");
  CHECK_THAT(analysis.check.statistics.front().size, WithinRel(0.05, 0.25));
  CHECK_THAT(analysis.summary, ContainsSubstring("twice to and fro in a turn of the robot"));
}

TEST_CASE("Of one wheel alone the check says what it depends on by the wheel's own command") {
  auto runs = clean_runs(44);
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      sample.command_m_s.right = 0.0;
      if (sample.ticks) sample.ticks->right = 0;
      sample.reference_x_m.reset();
      sample.reference_y_m.reset();
      sample.reference_theta_rad.reset();
    }
  }
  const auto analysis = analysed(runs);
  INFO(analysis.summary);
  REQUIRE_FALSE(analysis.check.statistics.empty());
  for (const CheckStatistic& statistic : analysis.check.statistics)
    CHECK_THAT(statistic.name, !ContainsSubstring("turning command"));
}

TEST_CASE("Where no effect was accepted every run is checked, else those alone that chose nothing") {
  const auto clean = analysed(clean_runs(45));
  REQUIRE(clean.search.final.model.effects.empty());
  CHECK(clean.checked == CheckedRuns::all);

  test::GapCaseSpec spec;
  spec.name = "dead_zone";
  spec.severity = test::Severity::large;
  spec.seed = 46;
  spec.runs = 3;
  spec.seconds = 28.0;
  spec.period_s = 0.03;
  const auto with_effect = analysed(test::make_gap_case(spec).runs);
  REQUIRE(with_effect.verdict == Verdict::named);
  CHECK(with_effect.checked == CheckedRuns::held_out);
}
