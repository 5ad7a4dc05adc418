// A gyro beside the counts: what it shows of turns, and what its own bias and scale must not be taken for.
#include <algorithm>
#include <cmath>

#include "model/gap/analysis.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/fit/free_run_errors.hpp"
#include "model/gap/runs/gyro_turns.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> logs_with_gyro(const std::string& hidden, double scale = 0.0,
                                     test::Channels channels = test::Channels::ticks) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = test::Severity::large;
  spec.channels = channels;
  spec.gyro = true;
  spec.runs = 3;
  spec.seconds = 50.0;
  spec.period_s = 0.03;
  auto logs = test::make_gap_case(spec).runs;
  for (DriveLog& log : logs) {
    for (DriveSample& sample : log.samples) *sample.gyro_z_rad_s *= 1.0 + scale;
  }
  return logs;
}

GapAnalysis analysed(std::span<const DriveLog> logs) {
  auto analysis = analyse_gap(logs.first(2), logs.last(1), {}, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

bool cannot_show(const GapAnalysis& analysis, const std::string& effect) {
  return std::ranges::count(analysis.not_testable, effect, &Untestable::effect) == 1;
}

}  // namespace

TEST_CASE("A rate that swings is integrated to the angle that it swings by") {
  constexpr double rate_hz = 0.5;
  DriveLog log;
  for (int k = 0; k <= 500; ++k) {
    DriveSample sample;
    sample.t_s = 0.02 * k;
    sample.gyro_z_rad_s = std::cos(rate_hz * sample.t_s);
    log.samples.push_back(sample);
  }
  const auto turns = gyro_turns(log);
  REQUIRE(turns.size() == log.samples.size());
  for (const auto& [row, turned_rad] : turns)
    CHECK_THAT(turned_rad, WithinAbs(std::sin(rate_hz * log.samples[row].t_s) / rate_hz, 1e-4));
}

TEST_CASE("A gyro that is silent for a second or in most rows is not integrated") {
  DriveLog log = logs_with_gyro("clean").front();
  DriveLog silent = log;
  for (std::size_t k = 1000; k < 1055; ++k) silent.samples[k].gyro_z_rad_s.reset();
  CHECK_FALSE(has_gyro(silent));
  for (std::size_t k = 0; k < log.samples.size(); k += 2) log.samples[k].gyro_z_rad_s.reset();
  CHECK_FALSE(has_gyro(log));
}

TEST_CASE("A steady bias of the gyro leaves no error") {
  const DriveLog log = logs_with_gyro("clean").front();
  DriveLog biased = log;
  for (DriveSample& sample : biased.samples) *sample.gyro_z_rad_s += 0.05;
  const GapRun run = make_gap_run(biased, {}, biased.period_s);
  REQUIRE(run.by_gyro);
  const auto errors = without_drift(run, run[Channel::turn].value);
  const GapRun unbiased = make_gap_run(log, {}, log.period_s);
  const auto expected = without_drift(unbiased, unbiased[Channel::turn].value);
  CHECK_THAT(errors.drift_rad_s - expected.drift_rad_s, WithinAbs(0.05, 1e-6));
  for (std::size_t i = 0; i < errors.errors_rad.size(); i += 100)
    CHECK_THAT(errors.errors_rad[i], WithinAbs(expected.errors_rad[i], 1e-5));
}

TEST_CASE("By counts and a gyro a scrub of the tyres is found, though nobody knows the gyro's scale") {
  const GapAnalysis analysis = analysed(logs_with_gyro("turn_scrub", 0.015));
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.size() == 1);
  CHECK(analysis.found.front().setting.name == "turn_scrub");
  const GapFigures& held_out = analysis.test;
  REQUIRE(held_out.before.heading_rms_rad);
  const double before_rad = held_out.before.heading_rms_rad->value;
  const double floor_rad = held_out.floor.heading_rms_rad->value;
  CHECK(before_rad - held_out.after.heading_rms_rad->value > 0.8 * (before_rad - floor_rad));
}

TEST_CASE("By counts and a gyro a caster that swings round is found") {
  const GapAnalysis analysis = analysed(logs_with_gyro("caster_kick"));
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "caster_kick");
}

TEST_CASE(
    "By counts and a gyro a sound robot lacks nothing, and the wheel base and places are not testable") {
  const GapAnalysis analysis = analysed(logs_with_gyro("clean", 0.02));
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK_THAT(analysis.search.final.model.gyro_scale(), WithinAbs(0.02, 0.003));
  for (const char* name : {"effective_track", "distance_scale", "lever_arm"})
    CHECK(cannot_show(analysis, name));
  for (const char* name : {"turn_scrub", "caster_kick"}) CHECK_FALSE(cannot_show(analysis, name));
}

TEST_CASE("A wheel base that is far off is seen by a gyro, and not told from the gyro's own scale") {
  const GapAnalysis analysis = analysed(logs_with_gyro("effective_track"));
  CHECK(analysis.verdict == Verdict::unnamed);
  CHECK(analysis.found.empty());
  CHECK_THAT(analysis.summary, ContainsSubstring("wheel base or the gyro's scale"));
}

TEST_CASE("First and last headings tell a wheel base that is off from the scale of a gyro between them") {
  const auto logs = logs_with_gyro("effective_track", 0.02, test::Channels::ticks_ends);
  const GapAnalysis analysis = analysed(logs);
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "effective_track");
  CHECK_THAT(analysis.search.final.model.gyro_scale(), WithinAbs(0.02, 0.005));
}

TEST_CASE("A gyro in degrees or of the other sign is a fault, and left out") {
  const double factor = GENERATE(57.29578, -1.0);
  DriveLog log = logs_with_gyro("clean").front();
  for (DriveSample& sample : log.samples) *sample.gyro_z_rad_s *= factor;
  const GatedLog gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK_THAT(gated.faults.front().what, ContainsSubstring("gyro"));
  CHECK_FALSE(gated.faults.front().explains);
  CHECK_FALSE(has_gyro(gated.log));
}
