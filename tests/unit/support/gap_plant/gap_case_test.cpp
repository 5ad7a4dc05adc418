// Cases of the gap benchmark: that each effect is really in its logs, more of it where it is larger, and that
// the answers say what the logs can show.
#include "tests/support/gap_plant/gap_case.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_plant.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

// RMS difference of two runs over what encoders (in m) and reference (in m and rad) show.
double distance_of(const DriveLog& a, const DriveLog& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.samples.size(); ++k) {
    const DriveSample& one = a.samples[k];
    const DriveSample& other = b.samples[k];
    const auto add = [&sum](double difference) { sum += difference * difference; };
    add(*one.reference_x_m - *other.reference_x_m);
    add(*one.reference_y_m - *other.reference_y_m);
    add(*one.reference_theta_rad - *other.reference_theta_rad);
    add(a.metres_per_tick->left * static_cast<double>(one.ticks->left - other.ticks->left));
    add(a.metres_per_tick->right * static_cast<double>(one.ticks->right - other.ticks->right));
  }
  return std::sqrt(sum / static_cast<double>(a.samples.size()));
}

GapCase quick_case(const std::string& name, Channels channels, Program program = Program::mixed) {
  GapCaseSpec spec;
  spec.name = name;
  spec.channels = channels;
  spec.program = program;
  spec.runs = 1;
  spec.seconds = 3.0;
  return make_gap_case(spec);
}

}  // namespace

TEST_CASE("A larger hidden effect leads the robot further from where it goes without") {
  const auto commands = drive_commands(Program::mixed, 30.0, 0.018, 0.258, 11);
  GapRunPlan plan;
  plan.charge_used_at_end = 1.0;
  const auto log_with = [&](const HiddenEffect* effect, Severity severity) {
    PlantParameters robot;
    robot.patch_length_m = robot.patch_width_m = 1.0;
    if (effect != nullptr) hide(robot, *effect, effect->size(severity), 4, false);
    return drive_plant(robot, commands, plan).log;
  };
  const DriveLog without = log_with(nullptr, Severity::small);
  for (const HiddenEffect& effect : hidden_effects()) {
    INFO(effect.name);
    const double small = distance_of(log_with(&effect, Severity::small), without);
    const double large = distance_of(log_with(&effect, Severity::large), without);
    CHECK(small > 0.0);
    CHECK(large > 1.5 * small);
  }
}

TEST_CASE("A case holds the channels that were asked for and no other") {
  const auto ticks = quick_case("clean", Channels::ticks).runs.front();
  CHECK(ticks.has_ticks());
  CHECK_FALSE(ticks.samples.front().reference_x_m);
  CHECK_FALSE(ticks.samples.front().gyro_z_rad_s);
  const auto ref = quick_case("clean", Channels::ref).runs.front();
  CHECK_FALSE(ref.has_ticks());
  CHECK(ref.samples[1].reference_x_m);
  const auto ends = quick_case("clean", Channels::ticks_ends).runs.front();
  CHECK(ends.samples.front().reference_theta_rad);
  CHECK(ends.samples.back().reference_theta_rad);
  CHECK_FALSE(ends.samples[1].reference_theta_rad);
  const auto sparse = quick_case("clean", Channels::sparse).runs.front();
  CHECK_FALSE(sparse.has_ticks());
  CHECK(sparse.samples[25].reference_y_m);
  CHECK_FALSE(sparse.samples[26].reference_y_m);
}

TEST_CASE("The answer of a case says what its logs can show") {
  CHECK(quick_case("clean", Channels::ticks).expected == Expected::nothing_missing);
  CHECK(quick_case("backlash", Channels::ticks).expected == Expected::named);
  CHECK(quick_case("backlash", Channels::ticks, Program::forward_only).expected == Expected::not_named);
  CHECK(quick_case("lever_arm", Channels::ticks).expected == Expected::not_named);
  CHECK(quick_case("distance_scale", Channels::ref).expected == Expected::not_named);
  CHECK(quick_case("distance_scale", Channels::ticks_ends).expected == Expected::named);
  CHECK(quick_case("turn_scrub", Channels::ticks_ref, Program::straight_only).expected ==
        Expected::not_named);
  CHECK(quick_case("outside_resonance", Channels::ticks).expected == Expected::unnamed);
  CHECK_THROWS(quick_case("no_such_effect", Channels::ticks));
  CHECK_THROWS(quick_case("backlash+backlash", Channels::ticks));
}

TEST_CASE("A case is the same each time it is made, and its programs keep to their names") {
  const auto once = quick_case("surface_patch", Channels::ticks_ref);
  const auto again = quick_case("surface_patch", Channels::ticks_ref);
  CHECK(distance_of(once.runs.front(), again.runs.front()) == 0.0);

  for (const auto& command : drive_commands(Program::forward_only, 60.0, 0.018, 0.258, 1)) {
    CHECK((command.left >= 0.0 && command.right >= 0.0));
  }
  for (const auto& command : drive_commands(Program::straight_only, 60.0, 0.018, 0.258, 1)) {
    CHECK(command.left == command.right);
  }
}
