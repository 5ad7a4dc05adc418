#include "model/log/anisotropic_scale.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

std::vector<DriveLog> seen_runs(const std::string& hidden, std::uint64_t seed) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = test::Severity::large;
  spec.channels = test::Channels::ticks_ref;
  spec.seed = seed;
  spec.runs = 3;
  spec.seconds = 60.0;
  return test::make_gap_case(spec).runs;
}

// Shortens what lies across a direction of the room, as a camera does that looks along the other at a slant;
// with `markers` the direction from one marker of the robot to another, too.
void look_at_a_slant(std::vector<DriveLog>& runs, double by, double direction_rad, bool markers) {
  const double c = std::cos(direction_rad);
  const double s = std::sin(direction_rad);
  const auto seen = [&](double x, double y) {
    const double along = c * x + s * y;
    const double across = (1.0 - by) * (c * y - s * x);
    return std::pair(c * along - s * across, s * along + c * across);
  };
  for (DriveLog& run : runs) {
    for (DriveSample& sample : run.samples) {
      const auto [x, y] = seen(*sample.reference_x_m, *sample.reference_y_m);
      sample.reference_x_m = x;
      sample.reference_y_m = y;
      if (!markers) continue;
      const auto [dx, dy] =
          seen(std::cos(*sample.reference_theta_rad), std::sin(*sample.reference_theta_rad));
      sample.reference_theta_rad = std::atan2(dy, dx);
    }
  }
}

std::optional<AnisotropicScale> scale_of(const std::vector<DriveLog>& runs) {
  std::vector<const DriveLog*> pointers;
  for (const DriveLog& run : runs) pointers.push_back(&run);
  return find_anisotropic_scale(pointers);
}

}  // namespace

TEST_CASE("No effect that a robot can have is taken for a reference of an anisotropic scale") {
  for (const auto& effect : test::hidden_effects()) {
    INFO(effect.name);
    CHECK_FALSE(scale_of(seen_runs(std::string(effect.name), 3)).has_value());
  }
}

TEST_CASE(
    "The ratio and the direction of an anisotropic scale are found, with headings by two markers and "
    "without") {
  for (const bool markers : {true, false}) {
    for (const double direction_rad : {0.0, 0.6, 2.5}) {
      for (const char* hidden : {"clean", "turn_scrub"}) {
        INFO(markers << " " << direction_rad << " " << hidden);
        auto runs = seen_runs(hidden, 5);
        look_at_a_slant(runs, 0.03, direction_rad, markers);
        const auto scale = scale_of(runs);
        REQUIRE(scale.has_value());
        CHECK_THAT(scale->largest_over_least(), WithinAbs(1.0 / 0.97, 0.006));
        CHECK(std::abs(std::sin(scale->longest_direction_rad() - direction_rad)) < 0.1);
        const double heading = std::hypot(scale->heading_along_rad, scale->heading_oblique_rad);
        if (markers) CHECK_THAT(heading, WithinAbs(0.015, 0.005));
        if (!markers) CHECK(heading < 0.005);
      }
    }
  }
}

TEST_CASE("The data gate puts a reference of an anisotropic scale right, in the metre of the counts") {
  auto runs = seen_runs("clean", 7);
  const auto straight = runs;
  look_at_a_slant(runs, 0.04, 0.3, true);
  const auto gated = gate_together(runs);
  bool said = false;
  for (const DataFault& fault : gated.front().faults)
    said = said || fault.text().find("it was made that of the counts in 3 runs") != std::string::npos;
  CHECK(said);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    CHECK(gated[r].log.reference_scaled_by_counts);
    const auto& first = straight[r].samples.front();
    const auto& right_first = gated[r].log.samples.front();
    for (std::size_t i = 0; i < runs[r].samples.size(); i += 100) {
      const auto& sample = straight[r].samples[i];
      const auto& right = gated[r].log.samples[i];
      CHECK_THAT(*right.reference_x_m - *right_first.reference_x_m,
                 WithinAbs(*sample.reference_x_m - *first.reference_x_m, 0.01));
      CHECK_THAT(*right.reference_y_m - *right_first.reference_y_m,
                 WithinAbs(*sample.reference_y_m - *first.reference_y_m, 0.01));
    }
  }
}
