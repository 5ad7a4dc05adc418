// What the delivery platform of the gap benchmark does with nothing hidden, and what hiding something
// changes.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/benchmark/fifth_plant/case_list.hpp"
#include "tests/benchmark/fifth_plant/vehicle.hpp"
#include "tests/benchmark/fifth_plant/visibility.hpp"
#include "tests/support/catch.hpp"

using namespace plants;
using namespace plants::fifth;

namespace {

constexpr std::uint64_t seed = 1;

// Both sides alike, and nothing shakes them.
Robot quiet_robot(Drive drive) {
  Random random(7);
  Robot robot = random_robot(drive, random);
  robot.sides[right_side] = robot.sides[left_side];
  for (SideSpec& side : robot.sides) side.motor.disturbance_n_m = 0.0;
  robot.floor.roughness = 0.0;
  return robot;
}

Vehicle vehicle_of(const Robot& robot) {
  return {robot, {}, robot.battery.full_v, Random(1)};
}

void hold(Vehicle& vehicle, const PerWheel<double>& command_m_s, double seconds) {
  for (long step = 0; step < std::lround(seconds / fine_step_s); ++step) vehicle.step(command_m_s);
}

double shaft_m(const Robot& robot, const Vehicle& vehicle) {
  return robot.encoder.metres_per_tick * static_cast<double>(vehicle.ticks()[left_side]);
}

bool same_rows(const std::vector<Run>& ones, const std::vector<Run>& others) {
  for (std::size_t run = 0; run < ones.size(); ++run) {
    const bool same = std::ranges::equal(ones[run].log.rows, others[run].log.rows,
                                         [](const LogRow& one, const LogRow& other) {
                                           return one.time_s == other.time_s && one.ticks == other.ticks &&
                                                  one.command_m_s == other.command_m_s;
                                         });
    if (!same) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("A delivery platform that is not asked to move stands still") {
  for (const Drive drive : {Drive::soft, Drive::stiff}) {
    Random random(3);
    Vehicle vehicle = vehicle_of(random_robot(drive, random));
    hold(vehicle, {}, 5.0);
    CHECK(vehicle.motion().pose.x_m == 0.0);
    CHECK(vehicle.motion().pose.heading_rad == 0.0);
    CHECK(vehicle.kinetic_energy_j() == 0.0);
  }
}

TEST_CASE("A symmetric delivery platform drives straight at the speed that it is asked for") {
  for (const Drive drive : {Drive::soft, Drive::stiff}) {
    const Robot robot = quiet_robot(drive);
    Vehicle vehicle = vehicle_of(robot);
    hold(vehicle, {0.3, 0.3}, 4.0);
    CHECK(std::abs(vehicle.motion().pose.heading_rad) < 1e-9);
    CHECK(std::abs(vehicle.motion().pose.y_m) < 1e-9);
    CHECK_THAT(vehicle.motion().forward_m_s, WithinRel(0.3, 0.001));
  }
}

TEST_CASE("A delivery platform turns by the speeds of its wheels and its wheel base") {
  const Robot robot = quiet_robot(Drive::stiff);
  Vehicle vehicle = vehicle_of(robot);
  hold(vehicle, {-0.1, 0.1}, 4.0);
  CHECK_THAT(vehicle.motion().turn_rad_s, WithinRel(0.2 / robot.wheel_base_m, 0.001));
  CHECK(std::abs(vehicle.motion().forward_m_s) < 1e-6);
}

TEST_CASE("A delivery platform gains no energy while it coasts") {
  Robot robot = quiet_robot(Drive::soft);
  for (SideSpec& side : robot.sides) side.driver.brakes = false;
  Vehicle vehicle = vehicle_of(robot);
  hold(vehicle, {0.3, 0.4}, 3.0);
  hold(vehicle, {}, 0.5);
  const double first_j = vehicle.kinetic_energy_j();
  double before_j = first_j;
  for (int tenth = 0; tenth < 20; ++tenth) {
    hold(vehicle, {}, 0.1);
    CHECK(vehicle.kinetic_energy_j() < before_j);
    before_j = vehicle.kinetic_energy_j();
  }
  CHECK(before_j > 0.1 * first_j);
}

TEST_CASE("Forces on a soft drive take the speed for which they were sized") {
  constexpr double loss_m_s = 0.03;
  constexpr double weight_m_s2 = 9.81;
  Robot robot = quiet_robot(Drive::soft);
  robot.floor.slope_rad = force_n(robot, loss_m_s) / (robot.mass_kg * weight_m_s2);
  Vehicle uphill = vehicle_of(robot);
  hold(uphill, {0.3, 0.3}, 4.0);
  CHECK_THAT(uphill.motion().forward_m_s, WithinAbs(0.3 - loss_m_s, 0.002));
  robot = quiet_robot(Drive::soft);
  set_both(robot, &GearSpec::dry_n_m, torque_n_m(robot, loss_m_s));
  Vehicle rubbing = vehicle_of(robot);
  hold(rubbing, {-0.3, -0.3}, 4.0);
  CHECK_THAT(rubbing.motion().forward_m_s, WithinAbs(-0.3 + loss_m_s, 0.002));
}

TEST_CASE("A gap between the teeth takes its width from each reversal") {
  constexpr double gap_m = 0.01;
  Robot robot = quiet_robot(Drive::stiff);
  for (SideSpec& side : robot.sides) side.wheel.drag_n_m = robot.mass_kg * side.wheel.radius_m;
  const auto back_m = [](const Robot& driven) {
    Vehicle vehicle = vehicle_of(driven);
    hold(vehicle, {0.2, 0.2}, 3.0);
    hold(vehicle, {}, 2.0);
    const double turned_m = shaft_m(driven, vehicle);
    hold(vehicle, {-0.2, -0.2}, 3.0);
    hold(vehicle, {}, 2.0);
    return turned_m - shaft_m(driven, vehicle);
  };
  const double without_m = back_m(robot);
  set_both(robot, &GearSpec::gap_rad, gap_m / robot.sides[left_side].wheel.radius_m);
  CHECK_THAT(without_m - back_m(robot), WithinAbs(gap_m, 0.001));
}

TEST_CASE("The fifth exam holds its parts, and each name of the contract in two sizes") {
  std::map<CaseKind, int> kinds;
  std::map<std::string, int> singles;
  for (const BuiltCase& built : build_cases(seed)) {
    ++kinds[built.exam.kind];
    const bool single = built.exam.kind == CaseKind::effects && built.exam.hidden.size() == 1;
    if (single) ++singles[built.exam.hidden.front().name + "." + built.exam.size];
  }
  CHECK(kinds == std::map<CaseKind, int>{{CaseKind::effects, 66},
                                         {CaseKind::clean, 16},
                                         {CaseKind::cannot_tell, 8},
                                         {CaseKind::outside, 28}});
  CHECK(singles.size() == 52);
}

TEST_CASE("The fifth exam is the same for a seed and another one for another") {
  const auto first_run = [](std::uint64_t of_seed) {
    Experiment experiment = build_cases(of_seed).front().hidden;
    experiment.runs = 1;
    return drive(experiment);
  };
  const std::vector<Run> driven = first_run(seed);
  CHECK(same_rows(driven, first_run(seed)));
  CHECK_FALSE(same_rows(driven, first_run(seed + 1)));
}

TEST_CASE("Runs of the fifth exam last as people drive, and their stamps rise") {
  Experiment experiment = build_cases(seed).back().hidden;
  for (const Run& run : drive(experiment)) {
    CHECK(run.log.rows.back().time_s > 45.0);
    CHECK(run.log.rows.back().time_s < 90.0);
    CHECK(std::ranges::is_sorted(run.log.rows, std::ranges::less_equal{}, &LogRow::time_s));
  }
}

TEST_CASE(
    "What has no name in the fifth exam is three times the noise, beside any linear model of the commands") {
  for (const BuiltCase& built : build_cases(seed)) {
    if (built.exam.kind != CaseKind::outside) continue;
    INFO(built.exam.name);
    CHECK(visibility(built.hidden, built.innocent).bent > 3.0);
  }
}

TEST_CASE("Effects of the fifth exam stand out of the noise, the large ones clearly") {
  for (const BuiltCase& built : build_cases(seed)) {
    if (built.exam.kind != CaseKind::effects || built.exam.hidden.size() > 1) continue;
    INFO(built.exam.name);
    CHECK(visibility(built.hidden, built.innocent).raw > (built.exam.size == "small" ? 1.5 : 3.0));
  }
}

TEST_CASE("What the drives of the fifth exam cannot show they do not show") {
  for (const BuiltCase& built : build_cases(seed)) {
    if (built.exam.kind != CaseKind::cannot_tell || !built.exam.sensors.ticks || built.exam.sensors.poses)
      continue;
    INFO(built.exam.name);
    CHECK(visibility(built.hidden, built.innocent).bent < 1.5);
  }
}
