#include "model/gap/candidates/eccentricity_phase.hpp"

#include <cmath>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// Three runs to fit and one held out, and the linear model of them.
struct Fitted {
  FitProblem train;
  FitProblem heldout;
  Fit fit;
};

FitProblem problem_of(std::span<const DriveLog> logs) {
  std::vector<GapRun> runs;
  std::vector<WheelPair> metres_per_tick;
  for (const auto& log : logs) {
    runs.push_back(make_gap_run(log, {}, log.period_s));
    measure_motion(runs.back());
    metres_per_tick.push_back(*log.metres_per_tick);
  }
  return {std::move(runs), std::move(metres_per_tick), serial_for};
}

Fitted fitted(const std::vector<DriveLog>& logs) {
  Fitted all{problem_of(std::span(logs).first(3)), problem_of(std::span(logs).subspan(3)), {}};
  const auto& log = logs.front();
  const TrialModel guess = first_guess({}, log.period_s, log.wheel_base_m, 0.06, 0.036);
  all.fit = all.train.fit(guess, 8);
  const NoiseModel noise = all.train.noise_left_by(all.fit.model);
  all.train.set_noise(noise);
  all.heldout.set_noise(noise);
  all.fit = all.train.fit(all.fit.model, 8);
  return all;
}

std::vector<DriveLog> plant_runs(const std::string& hidden) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.runs = 4;
  spec.seconds = 40.0;
  return test::make_gap_case(spec).runs;
}

std::optional<WheelAngles> angles_of(const Fitted& all) {
  return find_eccentricity_phases(all.train, all.heldout, all.fit, *find_effect("wheel_eccentricity"),
                                  serial_for);
}

// The library's own ripple, of 5 % and a wheel of 0.22 m, laid into a log of round wheels of which the left
// one had rolled so far before, and which nothing but its counts saw.
void add_ripple(DriveLog& log, double before_m) {
  const double per_metre = 2.0 * 3.14159265358979 / 0.22;
  const WheelTicks first = *log.samples.front().ticks;
  for (auto& sample : log.samples) {
    const double rolled_m = static_cast<double>(sample.ticks->left - first.left) * log.metres_per_tick->left;
    const double ripple_m =
        0.05 / per_metre * (std::cos(per_metre * before_m) - std::cos(per_metre * (before_m + rolled_m)));
    sample.ticks->left += std::lround(ripple_m / log.metres_per_tick->left);
    sample.reference_x_m = sample.reference_y_m = sample.reference_theta_rad = {};
  }
}

// A minute straight ahead, 2 % slower than commanded, on wheels that ripple by 30 % once in 0.22 m of way.
DriveLog slow_and_rippling() {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = 0.02;
  log.metres_per_tick = WheelPair{1e-5, 1e-5};
  double way_m = 0.0;
  for (int k = 0; k <= 3000; ++k) {
    const auto ticks = std::llround(1e5 * way_m);
    log.samples.push_back(
        {log.period_s * k, WheelPair{0.2, 0.2}, WheelTicks{ticks, ticks}, {}, {}, {}, {}, {}});
    for (int i = 0; i < 100; ++i)
      way_m += 2e-4 * 0.196 * (1.0 + 0.3 * std::sin(way_m / 0.22 * 2.0 * 3.14159265358979));
  }
  return log;
}

}  // namespace

TEST_CASE("Wheels that began each run at another angle give their circumference, and an angle for each run") {
  const auto found = angles_of(fitted(plant_runs("wheel_eccentricity")));
  REQUIRE(found);
  CHECK(found->differ);
  CHECK(found->train_rolled_m.size() == 3);
  CHECK(found->heldout_rolled_m.size() == 1);
  CHECK_THAT(found->start.parameters[4], WithinRel(0.226, 0.02));  // of the wheel, 72 mm across
}

TEST_CASE("Round wheels ripple nowhere") {
  const auto found = angles_of(fitted(plant_runs("clean")));
  if (found) {
    CHECK(std::hypot(found->start.parameters[0], found->start.parameters[1]) < 0.01);
    CHECK(std::hypot(found->start.parameters[2], found->start.parameters[3]) < 0.01);
  }
}

TEST_CASE("Where every run begins at the same angle, one angle serves all") {
  auto logs = plant_runs("clean");
  for (auto& log : logs) add_ripple(log, 0.0);
  const auto found = angles_of(fitted(logs));
  REQUIRE(found);
  CHECK_FALSE(found->differ);
  CHECK_THAT(found->start.parameters[4], WithinRel(0.22, 0.01));
  CHECK_THAT(found->start.parameters[0], WithinRel(0.05, 0.3));
}

TEST_CASE("Counts that go on from one run to the next tell the angle, and one serves all") {
  auto logs = plant_runs("clean");
  for (std::size_t run = 0; run < logs.size(); ++run) {
    const double before_m = 1.37 * static_cast<double>(run + 1);
    add_ripple(logs[run], before_m);
    const auto before = std::lround(before_m / logs[run].metres_per_tick->left);
    const auto further = before - logs[run].samples.front().ticks->left;
    for (auto& sample : logs[run].samples) sample.ticks->left += further;
  }
  const auto found = angles_of(fitted(logs));
  REQUIRE(found);
  CHECK_FALSE(found->differ);
  CHECK_THAT(found->train_rolled_m[2].left - found->train_rolled_m[0].left, WithinAbs(2.74, 0.001));
  CHECK_THAT(found->start.parameters[4], WithinRel(0.22, 0.01));
}

TEST_CASE("A ripple is fitted at the angle that counts tell, though the model's own way goes astray") {
  const DriveLog log = slow_and_rippling();
  TrialModel model = first_guess({}, log.period_s, log.wheel_base_m, 0.0, 0.005);
  model.effects = {{find_effect("wheel_eccentricity"), 1, {0.3, 0.0, 0.3, 0.0, 0.22}}};
  const auto errors = free_run_errors(model, make_gap_run(log, {}, log.period_s)).series.front();
  const double last_m = errors.back() - errors.front();
  REQUIRE_THAT(last_m, WithinAbs(-0.24, 0.02));  // a whole turn
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(errors.size() - 1);
    CHECK_THAT(errors[i], WithinAbs(share * last_m, 0.003));  // the ripple itself is 10 mm either way
  }
}
