#include "model/log/heading_offset.hpp"

#include <cmath>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> runs_with(const std::string& hidden, std::uint64_t seed,
                                test::Channels channels = test::Channels::ticks_ref) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = test::Severity::large;
  spec.channels = channels;
  spec.seed = seed;
  spec.runs = 3;
  spec.seconds = 60.0;
  return test::make_gap_case(spec).runs;
}

std::vector<HeadingOffset> offsets_of(const std::vector<DriveLog>& runs) {
  std::vector<const DriveLog*> pointers;
  for (const DriveLog& run : runs) pointers.push_back(&run);
  return heading_offsets(pointers);
}

void turn_all(std::vector<DriveLog>& runs, double by_rad) {
  for (DriveLog& run : runs) turn_headings(run, {.offset_rad = by_rad});
}

bool is_said(const std::vector<GatedLog>& gated, const std::string& words) {
  for (const GatedLog& log : gated) {
    for (const DataFault& fault : log.faults) {
      if (fault.text().find(words) != std::string::npos) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("No effect that a robot can have is taken for a heading that is turned") {
  for (const auto& effect : test::hidden_effects()) {
    INFO(effect.name);
    for (const HeadingOffset& offset : offsets_of(runs_with(std::string(effect.name), 3)))
      CHECK_FALSE(is_turned(offset));
  }
}

TEST_CASE("A heading that is turned on the robot is found to its standard error, beside a lever arm too") {
  for (const char* hidden : {"clean", "lever_arm", "floor_slope", "turn_scrub"}) {
    for (const double turned_rad : {0.03, -0.2, 1.5}) {
      INFO(hidden << " " << turned_rad);
      auto runs = runs_with(hidden, 5);
      turn_all(runs, turned_rad);
      for (const HeadingOffset& offset : offsets_of(runs)) {
        CHECK(std::abs(offset.offset_rad + turned_rad) < 5.0 * offset.standard_error_rad + 0.002);
        CHECK(offset.standard_error_rad < 0.01);
      }
    }
  }
}

TEST_CASE("A turned heading is found without counts, and by one pose in half a second") {
  for (const auto channels : {test::Channels::ref, test::Channels::ticks_sparse}) {
    auto runs = runs_with("clean", 7, channels);
    turn_all(runs, 0.1);
    for (const HeadingOffset& offset : offsets_of(runs)) CHECK_THAT(offset.offset_rad, WithinAbs(-0.1, 0.01));
  }
}

TEST_CASE("A run whose tracker was taught again has an offset of its own") {
  auto runs = runs_with("clean", 9);
  turn_headings(runs.back(), {.offset_rad = 0.15});
  const auto offsets = offsets_of(runs);
  CHECK(std::abs(offsets.front().offset_rad) < 0.01);
  CHECK_THAT(offsets.back().offset_rad, WithinAbs(-0.15, 0.01));
}

TEST_CASE("Half a turn may be commands of the other sign, and stays a contradiction") {
  auto runs = runs_with("clean", 11);
  turn_all(runs, 3.1);
  for (const HeadingOffset& offset : offsets_of(runs)) CHECK_FALSE(is_turned(offset));
  CHECK(is_said(gate_together(runs), "turned by half a turn"));
}

TEST_CASE("The data gate turns a heading back and says so") {
  auto runs = runs_with("clean", 13);
  const auto straight = runs;
  turn_all(runs, 0.1);
  const auto gated = gate_together(runs);
  CHECK(is_said(gated, "the heading of the reference is turned by 5."));
  CHECK(is_said(gated, "it was turned back in 3 runs"));
  CHECK(gated.back().faults.empty());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CHECK_THAT(*gated[i].log.samples.back().reference_theta_rad,
               WithinAbs(*straight[i].samples.back().reference_theta_rad, 0.01));
  }
}

TEST_CASE(
    "A heading that drifts, and one whose turns are out of scale, are put right by the way that it moves") {
  for (const double drift_rad_per_s : {0.0, 0.0015, -0.002}) {
    for (const double per_radian : {0.0, 0.01}) {
      INFO(drift_rad_per_s << " " << per_radian);
      auto runs = runs_with("clean", 15);
      const auto true_runs = runs;
      for (DriveLog& run : runs)
        turn_headings(run, {.drift_rad_per_s = drift_rad_per_s, .per_radian = per_radian});
      const auto offsets = offsets_of(runs);
      for (std::size_t i = 0; i < runs.size(); ++i) {
        CHECK_THAT(offsets[i].drift_rad_per_s, WithinAbs(-drift_rad_per_s, 1e-4));
        CHECK((offsets[i].per_radian != 0.0) == (per_radian != 0.0));
        turn_headings(runs[i], offsets[i]);
        double worst = 0.0;
        for (std::size_t row = 0; row < runs[i].samples.size(); ++row)
          worst = std::max(worst, std::abs(*runs[i].samples[row].reference_theta_rad -
                                           *true_runs[i].samples[row].reference_theta_rad));
        CHECK(worst < 0.012);
      }
    }
  }
}
