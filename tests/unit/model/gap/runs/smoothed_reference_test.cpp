// References that a tracker has smoothed, and such as a camera sees at a slant.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/smoothed_reference.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

GapAnalysis analysed_after(const std::string& hidden, const std::function<void(DriveLog&)>& change) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.channels = test::Channels::ticks_ref;
  spec.runs = 3;
  spec.seconds = 40.0;
  spec.period_s = 0.03;
  auto logs = test::make_gap_case(spec).runs;
  for (DriveLog& log : logs) change(log);
  auto analysis = analyse_gap(std::span(logs).first(2), std::span(logs).last(1), {}, serial_for,
                              [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

std::vector<std::string> names_of(const GapAnalysis& analysis) {
  std::vector<std::string> names;
  for (const auto& finding : analysis.found) names.push_back(finding.setting.name);
  return names;
}

void smooth(DriveLog& log) {
  test::filter_reference(log, test::low_pass(0.2), test::low_pass(0.2));
}

void shorten_x(DriveLog& log) {
  for (DriveSample& sample : log.samples) *sample.reference_x_m *= 0.97;
}

}  // namespace

TEST_CASE("What the floor does is named through a tracker that smooths") {
  CHECK(names_of(analysed_after("turn_scrub", smooth)) == std::vector<std::string>{"turn_scrub"});
}

TEST_CASE(
    "A tracker that smooths is nothing that the robot's model lacks: predictions are smoothed likewise") {
  const auto analysis = analysed_after("clean", smooth);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK(names_of(analysis).empty());
  const Score& smoothed = analysis.test.after;
  const auto plain = analysed_after("clean", [](DriveLog&) {}).test.after;
  CHECK(smoothed.position_rms_m->value < 1.2 * plain.position_rms_m->value);
  CHECK(smoothed.heading_rms_rad->value < 1.2 * plain.heading_rms_rad->value);
}

TEST_CASE("A camera that looks at a slant is no scale of the counts, which is not tested then") {
  const auto analysis = analysed_after("clean", shorten_x);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  const auto untested = std::ranges::find(analysis.not_testable, "distance_scale", &Untestable::effect);
  REQUIRE(untested != analysis.not_testable.end());
  CHECK(untested->why.find("metre was made that of the counts") != std::string::npos);
}

TEST_CASE("Lost counts break a smoothed reference for as long as it still shows them") {
  test::GapCaseSpec spec;
  spec.channels = test::Channels::ticks_ref;
  DriveLog log = test::make_gap_case(spec).runs.front();
  log.reference_response = {{0.0, 0.1, {0.5, 0.5}}, {}};  // 0.05 s late, a rise time of 0.16 s
  RowFlags flags{std::vector<char>(log.samples.size(), 0), std::vector<char>(log.samples.size(), 0)};
  flags.counts[500] = 1;
  const GapRun run = make_gap_run(log, flags, log.period_s);
  const double known_again_s = log.samples[501].t_s + 0.21;
  for (std::size_t i = 490; i < 530; ++i) {
    INFO(i);
    CHECK(run.references[i].counts_lost == (i >= 500 && (i <= 501 || log.samples[i].t_s < known_again_s)));
  }
}
