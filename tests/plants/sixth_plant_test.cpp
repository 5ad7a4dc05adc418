// What the educational robot of the gap benchmark does with nothing hidden, and what hiding something
// changes.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/benchmark/sixth_plant/case_builder.hpp"
#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/simulation.hpp"
#include "tests/support/catch.hpp"

using namespace plants;
using namespace plants::sixth;

namespace {

constexpr std::uint64_t seed = 1;

Robot quiet_robot() {
  Random random(7);
  Robot robot = random_robot(random);
  robot.noise = {};
  robot.jitters = false;
  return robot;
}

DriveScript held(const Robot& robot, const PerWheel<double>& command_m_s, double seconds) {
  DriveScript script;
  for (long row = 0; row < std::lround(seconds / robot.period_s); ++row) {
    script.time_s.push_back(static_cast<double>(row) * robot.period_s);
    script.command_m_s.push_back(command_m_s);
  }
  return script;
}

DriveScript driven_by_hand(const Robot& robot, Programme programme) {
  Hand hand(robot, {}, Random(5));
  drive(hand, programme, 30.0);
  DriveScript script = hand.script();
  script.noise_seed = 3;
  return script;
}

bool same_rows(const Run& one, const Run& other) {
  return std::ranges::equal(one.log.rows, other.log.rows, [](const LogRow& left, const LogRow& right) {
    return left.time_s == right.time_s && left.command_m_s == right.command_m_s &&
           left.ticks == right.ticks && left.reference->x_m == right.reference->x_m &&
           left.reference->y_m == right.reference->y_m;
  });
}

}  // namespace

TEST_CASE("An educational robot that is not asked to move stands still") {
  const Robot robot = quiet_robot();
  const Run run = simulate(robot, {}, held(robot, {}, 3.0));
  CHECK(run.truth.back().reference_point.x_m == 0.0);
  CHECK(run.truth.back().heading_rad == 0.0);
  CHECK(run.log.rows.back().ticks == PerWheel<long>{});
}

TEST_CASE("An educational robot reaches the commanded speed, and keeps straight") {
  const Robot robot = quiet_robot();
  const double asked_m_s = 0.6 * robot.top_m_s;
  const Run run = simulate(robot, {}, held(robot, {asked_m_s, asked_m_s}, 4.0));
  const auto rows_of_a_second = std::lround(1.0 / robot.period_s);
  const auto before = run.truth.end() - 1 - rows_of_a_second;
  const double covered_m = run.truth.back().reference_point.x_m - before->reference_point.x_m;
  const double covered_s = static_cast<double>(rows_of_a_second) * robot.period_s;
  CHECK_THAT(covered_m / covered_s, WithinRel(robot.gain * asked_m_s, 0.02));
  CHECK(std::abs(run.truth.back().reference_point.y_m) < 1e-9);
}

TEST_CASE("Each effect of the sixth exam moves an educational robot otherwise than its clean twin") {
  Random random(11);
  const Robot robot = random_robot(random);
  for (std::size_t index = 0; index < effect_count; ++index) {
    const auto effect = static_cast<Effect>(index);
    const EffectEntry& entry = entry_of(effect);
    INFO(entry.name);
    CHECK(entry.effect == effect);
    Hidden hidden;
    hidden.details.coin = 1.0;
    hidden.details.warming_s = 20.0;
    hidden.details.patch_half_m = 0.2;
    hidden.details.usual_heat = 0.1;
    const DriveScript script = driven_by_hand(robot, entry.programmes.front());
    const Run clean = simulate(robot, hidden, script);
    hidden[effect] = entry.largest;
    CHECK_FALSE(same_rows(simulate(robot, hidden, script), clean));
  }
}

TEST_CASE("The sixth exam hides each name twice") {
  std::map<std::string, int> singles;
  const std::vector<PlannedCase> cases = planned_cases(seed);
  CHECK(cases.size() == 112);
  for (const PlannedCase& plan : cases)
    if (plan.expected == Expected::named && plan.hidden.size() == 1) ++singles[plan.name];
  CHECK(singles.size() == 26);
  CHECK(std::ranges::all_of(singles, [](const auto& single) { return single.second == 2; }));
}

TEST_CASE(
    "A case of the sixth exam is the same whatever was built before, and another one for another seed") {
  const auto last_clean = [](std::uint64_t of_seed) {
    const std::vector<PlannedCase> cases = planned_cases(of_seed);
    return *std::ranges::find(cases.rbegin(), cases.rend(), "clean", &PlannedCase::name);
  };
  const BuiltCase alone = build_case(last_clean(seed));
  const BuiltCase other = build_case(last_clean(seed + 1));
  const BuiltCase again = build_case(last_clean(seed));
  CHECK(same_rows(alone.runs.front(), again.runs.front()));
  CHECK_FALSE(same_rows(alone.runs.front(), other.runs.front()));
}
