// References that tell the heading and no place: a compass, or a camera that sees an arrow.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/gap/analysis.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/runs/run.hpp"
#include "model/prediction/open_loop_runs.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

void keep_heading_alone(DriveLog& log) {
  for (DriveSample& sample : log.samples) {
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
  }
}

GapAnalysis analysed_by_heading(const std::string& hidden) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = test::Severity::large;
  spec.channels = test::Channels::ticks_ref;
  spec.runs = 3;
  spec.seconds = 50.0;
  spec.period_s = 0.03;
  auto logs = test::make_gap_case(spec).runs;
  for (DriveLog& log : logs) keep_heading_alone(log);
  auto analysis = analyse_gap(std::span(logs).first(2), std::span(logs).last(1), {}, serial_for,
                              [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

// On the spot at 5 rad/s, with a heading once a second; where there are counts, at what they say.
DriveLog spinning(bool counted) {
  constexpr double tick_m = 1e-4;
  constexpr double turn_rate_rad_s = 5.0;
  DriveLog log;
  log.wheel_base_m = 0.2;
  log.period_s = 0.02;
  if (counted) log.metres_per_tick = WheelPair{tick_m, tick_m};
  const double rim_m_s = 0.5 * turn_rate_rad_s * log.wheel_base_m;
  for (int k = 0; k <= 500; ++k) {
    DriveSample sample;
    sample.t_s = log.period_s * k;
    sample.command_m_s = {-rim_m_s, rim_m_s};
    const auto ticks = static_cast<std::int64_t>(std::lround(rim_m_s * sample.t_s / tick_m));
    if (counted) sample.ticks = WheelTicks{-ticks, ticks};
    if (k % 50 == 0) sample.reference_theta_rad = wrap_angle(turn_rate_rad_s * sample.t_s);
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace

TEST_CASE("By the heading alone a scrub of the tyres is found, and no figure of position is made up") {
  const GapAnalysis analysis = analysed_by_heading("turn_scrub");
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "turn_scrub");
  CHECK_FALSE(analysis.test.before.position_rms_m);
  const GapFigures& held_out = analysis.test;
  REQUIRE(held_out.before.heading_rms_rad);
  const double before_rad = held_out.before.heading_rms_rad->value;
  const double floor_rad = held_out.floor.heading_rms_rad->value;
  CHECK(before_rad - held_out.after.heading_rms_rad->value > 0.8 * (before_rad - floor_rad));
}

TEST_CASE("By the heading alone a sound robot lacks nothing, and what tells of places is not testable") {
  const GapAnalysis analysis = analysed_by_heading("clean");
  CHECK(analysis.verdict == Verdict::nothing_missing);
  for (const char* name : {"distance_scale", "surface_patch", "lever_arm"})
    CHECK(std::ranges::count(analysis.not_testable, name, &Untestable::effect) == 1);
}

TEST_CASE("Between two headings that are far apart a robot may turn by more than half a turn") {
  const DriveLog log = spinning(GENERATE(false, true));
  const GapRun run = make_gap_run(log, {}, log.period_s);
  CHECK(run.heading_alone);
  REQUIRE(run.references.size() == 11);
  CHECK_THAT(run.references.back().pose.theta_rad, WithinAbs(50.0, 1e-9));
}

TEST_CASE("A heading that leaps and comes back is left out where there is nothing but headings") {
  DriveLog log = spinning(true);
  for (DriveSample& sample : log.samples) sample.reference_theta_rad = wrap_angle(5.0 * sample.t_s);
  log.samples[200].reference_theta_rad = wrap_angle(5.0 * log.samples[200].t_s + 2.0);
  const GatedLog gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK(gated.faults.front().row == 201);  // counted from 1
  CHECK_FALSE(gated.log.samples[200].reference_theta_rad);
  CHECK(gated.log.samples[201].reference_theta_rad);
}

TEST_CASE("A model with a slope in it is told the heading where no reference tells more") {
  constexpr double period_s = 0.02;
  constexpr double wheel_base_m = 0.2;
  const LinearModel linear_part{
      ModelType::arma, period_s, wheel_base_m, {{1.0}, {0.0}, {}}, {{0.0}, {1.0}, {}}};
  DriveLog log;
  log.wheel_base_m = wheel_base_m;
  log.period_s = period_s;
  for (int k = 0; k <= 1000; ++k) {
    DriveSample sample;
    sample.t_s = period_s * k;
    sample.command_m_s = {0.1, 0.1};
    sample.reference_theta_rad = k < 500 ? 0.0 : 0.5 * std::numbers::pi;
    log.samples.push_back(sample);
  }
  RobotModel model{};
  model.linear_part = linear_part;
  model.effects.emplace_back().setting = {"floor_slope", "wheel", {0.03, 0.0}};
  REQUIRE(is_reset_to_measured_pose(model, log));
  const auto runs = open_loop_runs(model, log);
  // Told at 10 s that it heads along y, it feels no slope along x any more.
  const auto speed_at_15_s = [](const auto& run) { return run[750].speed_m_s.left; };
  CHECK_THAT(speed_at_15_s(runs.front()), WithinAbs(0.1, 1e-3));
}
