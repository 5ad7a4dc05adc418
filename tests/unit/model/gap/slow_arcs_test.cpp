// Drives that turn slowly: what they show is a matter of how far they turn, not of how fast.
#include <algorithm>
#include <cmath>
#include <random>

#include "model/gap/analysis.hpp"
#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double track_m = 0.235;  // as the log has it
constexpr double speed_m_s = 0.15;
constexpr double tick_m = 0.00044;

// What the floor makes of what the wheels count.
struct Floor {
  double excess_track_m = 0.0;
  double scale = 0.0;
};

// An arc of 25 s at constant speed, from rest to rest, by wheels that lag; a pose on each `every`th row, or
// on the first and last alone.
DriveLog arc(int index, double turn_rate_rad_s, const Floor& floor, std::optional<std::size_t> every = {}) {
  constexpr std::size_t rows = 1300;
  std::mt19937_64 random(static_cast<std::uint64_t>(index) + 7U);
  std::normal_distribution<double> noise;
  DriveLog log;
  log.name = "arc" + std::to_string(index);
  log.wheel_base_m = track_m;
  log.period_s = period_s;
  log.metres_per_tick = {tick_m, tick_m};
  const double half = 0.5 * turn_rate_rad_s * track_m;
  WheelPair speed;
  WheelPair travel;
  Pose pose;
  for (std::size_t k = 0; k < rows; ++k) {
    DriveSample sample;
    sample.t_s = period_s * static_cast<double>(k);
    const bool drives = k >= 25 && k < rows - 75;
    if (drives) sample.command_m_s = {speed_m_s - half, speed_m_s + half};
    sample.ticks = {std::lround(travel.left / tick_m), std::lround(travel.right / tick_m)};
    if (every ? k % *every == 0 : (k == 0 || k + 1 == rows)) {
      sample.reference_x_m = pose.x_m + 1e-3 * noise(random);
      sample.reference_y_m = pose.y_m + 1e-3 * noise(random);
      sample.reference_theta_rad = wrap_angle(pose.theta_rad + 2e-3 * noise(random));
    }
    log.samples.push_back(sample);
    const double share = period_s / 0.08;
    speed.left += share * (sample.command_m_s.left - speed.left);
    speed.right += share * (sample.command_m_s.right - speed.right);
    const WheelPair rolled{period_s * (speed.left + (drives ? 2e-3 * noise(random) : 0.0)),
                           period_s * (speed.right + (drives ? 2e-3 * noise(random) : 0.0))};
    travel = {travel.left + rolled.left, travel.right + rolled.right};
    const double grown = 1.0 + floor.scale;
    pose = move_along_arc(
        pose, twist_of_wheels({grown * rolled.left, grown * rolled.right}, track_m + floor.excess_track_m),
        1.0);
  }
  return log;
}

std::vector<DriveLog> arcs(const Floor& floor) {
  constexpr int count = 8;
  std::vector<DriveLog> logs;
  logs.reserve(count);
  for (int i = 0; i < count; ++i) logs.push_back(arc(i, i % 2 == 0 ? 0.06 : -0.06, floor));
  return logs;
}

GapAnalysis analysed(const std::vector<DriveLog>& logs) {
  auto analysis = analyse_gap(logs, {}, {}, serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

bool listed(const GapAnalysis& analysis, std::string_view effect) {
  return std::ranges::count(analysis.not_testable, effect, &Untestable::effect) > 0;
}

}  // namespace

TEST_CASE("Slow arcs with a pose at each end show a track that is wider than given") {
  const auto analysis = analysed(arcs({.excess_track_m = 0.02}));
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  CHECK(analysis.found.front().setting.name == "effective_track");
  CHECK(analysis.found.front().intervals.front().lower < 0.02);
  CHECK(analysis.found.front().intervals.front().upper > 0.02);
  CHECK_THAT(analysis.found.front().setting.parameters.front(), WithinAbs(0.02, 0.004));
}

TEST_CASE("Slow arcs with a pose at each end show wheels that roll further than counted") {
  const auto analysis = analysed(arcs({.scale = 0.03}));
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  CHECK(analysis.found.front().setting.name == "distance_scale");
  CHECK_THAT(analysis.found.front().setting.parameters.front(), WithinAbs(0.03, 0.006));
}

TEST_CASE("Slow arcs of which nothing is missing are given no name, and say how small a track would show") {
  const auto analysis = analysed(arcs({}));
  INFO(analysis.summary);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK_FALSE(listed(analysis, "effective_track"));
  CHECK_FALSE(listed(analysis, "distance_scale"));
  const auto track = std::ranges::find(analysis.detectable, "effective_track", &Detectable::effect);
  REQUIRE(track != analysis.detectable.end());
  CHECK(track->size < 0.03);
}

TEST_CASE("A slope is not looked for where all travel is within half a turn") {
  CHECK(listed(analysed(arcs({})), "floor_slope"));
}

TEST_CASE("A reference that turns the other way is a fault of the data at any turn rate") {
  DriveLog log = arc(0, 0.06, {}, 50);
  CHECK(gate(log).faults.empty());
  for (auto& sample : log.samples) {
    if (!sample.reference_theta_rad) continue;
    sample.reference_theta_rad = -*sample.reference_theta_rad;
    sample.reference_y_m = -*sample.reference_y_m;
  }
  const auto faults = gate(log).faults;
  REQUIRE(faults.size() == 1);
  CHECK(faults.front().explains);
  CHECK_THAT(faults.front().what, ContainsSubstring("turns against the wheels"));
}
