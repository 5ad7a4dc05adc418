// What the robot of the gap benchmark does with nothing hidden, and with each effect alone.
#include "tests/support/gap_plant/gap_plant.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/drive_program.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

constexpr double period_s = 0.018;

PlantParameters quiet_robot() {
  PlantParameters robot;
  robot.speed_noise_m_s = robot.slip_noise_share = 0.0;
  robot.reference_noise_m = robot.reference_noise_rad = 0.0;
  robot.gyro_noise_rad_s = robot.battery_noise_v = 0.0;
  return robot;
}

PlantParameters with(std::string_view effect, double size) {
  PlantParameters robot = quiet_robot();
  hide(robot, *find_hidden_effect(effect), size, 1, false);
  return robot;
}

std::vector<WheelPair> held(const WheelPair& command, double seconds) {
  return std::vector<WheelPair>(static_cast<std::size_t>(seconds / period_s), command);
}

std::vector<WheelPair> operator+(std::vector<WheelPair> first, const std::vector<WheelPair>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

PlantTruth end_of(const PlantParameters& robot, const std::vector<WheelPair>& commands) {
  return drive_plant(robot, commands, {}).truth.back();
}

}  // namespace

TEST_CASE("With nothing hidden and no noise the gap plant obeys superposition") {
  const auto a = drive_commands(Program::mixed, 20.0, period_s, 0.258, 1);
  const auto b = drive_commands(Program::mixed, 20.0, period_s, 0.258, 2);
  auto sum = a;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k] = {0.5 * (a[k].left + b[k].left), 0.5 * (a[k].right + b[k].right)};
  }
  for (const double controller : {0.0, 1.0}) {
    PlantParameters robot = quiet_robot();
    robot.controller_gain = controller;
    robot.controller_integral_hz = controller;
    robot.motor_gain = {0.98, 1.02};
    const auto of_a = drive_plant(robot, a, {});
    const auto of_b = drive_plant(robot, b, {});
    const auto of_sum = drive_plant(robot, sum, {});
    double worst = 0.0;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      const double expected = 0.5 * (of_a.truth[k].rim_m.left + of_b.truth[k].rim_m.left);
      worst = std::max(worst, std::abs(of_sum.truth[k].rim_m.left - expected));
    }
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("The gap plant follows a command after a delay and a lag, with a gain of one") {
  const auto run = drive_plant(quiet_robot(), held({0.2, 0.2}, 2.0), {});
  CHECK(run.truth[1].rim_m_s.left == 0.0);
  CHECK_THAT(run.truth.back().rim_m_s.left, WithinRel(0.2, 1e-6));
  CHECK_THAT(run.truth.back().pose.x_m, WithinRel(run.truth.back().rim_m.left, 1e-9));
  const auto reached = std::find_if(run.truth.begin(), run.truth.end(),
                                    [](const PlantTruth& truth) { return truth.rim_m_s.left > 0.126; });
  const double after_s = period_s * static_cast<double>(reached - run.truth.begin());
  CHECK(after_s > 0.08);
  CHECK(after_s < 0.18);
}

TEST_CASE("The same seed gives the same run, another seed another") {
  const auto commands = drive_commands(Program::mixed, 10.0, period_s, 0.258, 3);
  GapRunPlan plan;
  const auto reference_x = [&](std::uint64_t seed) {
    plan.seed = seed;
    return *drive_plant(random_robot(7), commands, plan).log.samples.back().reference_x_m;
  };
  CHECK(reference_x(5) == reference_x(5));
  CHECK(reference_x(5) != reference_x(6));
}

TEST_CASE("A dead zone moves nothing below its threshold, whichever part has it") {
  for (const auto threshold : {&PlantParameters::firmware_threshold_m_s, &PlantParameters::crossover_m_s}) {
    PlantParameters robot = quiet_robot();
    robot.*threshold = 0.03;
    CHECK_THAT(end_of(robot, held({0.02, -0.02}, 2.0)).rim_m.left, WithinAbs(0.0, 0.0006));
    CHECK(end_of(robot, held({0.06, 0.06}, 2.0)).rim_m.left > 0.04);
  }
}

TEST_CASE("Coulomb friction takes the same speed at any speed, and a controller hides half of it") {
  PlantParameters robot = with("coulomb_friction", 0.02);
  for (const double command : {-0.3, -0.1, 0.1, 0.3}) {
    const double lost =
        std::abs(command) - std::abs(end_of(robot, held({command, command}, 2.0)).rim_m_s.left);
    CHECK_THAT(lost, WithinRel(0.02, 0.02));
  }
  robot.controller_gain = 1.0;
  CHECK_THAT(0.2 - end_of(robot, held({0.2, 0.2}, 2.0)).rim_m_s.left, WithinRel(0.01, 0.02));
}

TEST_CASE("Stiction holds a wheel at rest under a command that keeps a moving wheel going") {
  const PlantParameters robot = with("stiction", 0.05);
  CHECK_THAT(end_of(robot, held({0.04, 0.04}, 2.0)).rim_m.left, WithinAbs(0.0, 0.001));
  const auto slowed = held({0.2, 0.2}, 1.0) + held({0.04, 0.04}, 2.0);
  CHECK(end_of(robot, slowed).rim_m_s.left > 0.03);
}

TEST_CASE("Backlash loses the play once in a reversal") {
  auto there_and_back = held({0.1, 0.1}, 2.0) + held({-0.1, -0.1}, 1.0);
  const double without = end_of(quiet_robot(), there_and_back).rim_m.left;
  const double lost = end_of(with("backlash", 0.004), there_and_back).rim_m.left - without;
  CHECK_THAT(lost, WithinAbs(0.002, 1e-6));  // half of the play going out, the whole of it coming back
}

TEST_CASE("Wheels of different size turn the robot by their difference over the track, in a metre") {
  PlantParameters robot = with("wheel_scale_mismatch", 0.02);
  const auto end = end_of(robot, held({0.2, 0.2}, 5.0));
  CHECK_THAT(std::abs(end.pose.theta_rad), WithinRel(0.02 / robot.wheel_base_m * end.rim_m.left, 1e-3));
}

TEST_CASE("A wider track turns less for the same travel of the wheels") {
  const auto turned = [](const PlantParameters& robot) {
    return end_of(robot, held({-0.1, 0.1}, 4.0)).pose.theta_rad;
  };
  CHECK_THAT(turned(quiet_robot()) / turned(with("effective_track", 0.05)), WithinRel(1.05, 1e-6));
}

TEST_CASE("A rail limits the speed, and a slew rate the change of it") {
  CHECK(end_of(with("saturation", 0.2), held({0.4, 0.4}, 2.0)).rim_m_s.left < 0.2);
  const auto run = drive_plant(with("rate_limit", 0.7), held({0.4, 0.4}, 2.0), {});
  for (std::size_t k = 1; k < run.truth.size(); ++k) {
    CHECK(run.truth[k].rim_m_s.left - run.truth[k - 1].rim_m_s.left < 0.7 * period_s * 1.001);
  }
}

TEST_CASE("Forward and reverse gains differ by the size that was hidden") {
  const PlantParameters robot = with("direction_gain", 0.06);
  const double forward = end_of(robot, held({0.2, 0.2}, 2.0)).rim_m_s.left / 0.2;
  const double reverse = end_of(robot, held({-0.2, -0.2}, 2.0)).rim_m_s.left / -0.2;
  CHECK_THAT(std::abs(forward - reverse), WithinRel(0.06, 0.05));
}

TEST_CASE("A warm motor loses the share that was hidden") {
  PlantParameters robot = with("gain_drift", 0.1);
  CHECK_THAT(end_of(robot, held({0.2, 0.2}, 150.0)).rim_m_s.left, WithinRel(0.18, 0.01));
}

TEST_CASE("A caster turns the robot once after each reversal, within centimetres") {
  PlantParameters robot = with("caster_kick", 0.05);
  robot.upset_loads_motors = false;
  robot.caster_turns_on = false;
  const auto heading_after = [&](const std::vector<WheelPair>& commands) {
    return std::abs(end_of(robot, commands).pose.theta_rad);
  };
  const auto out = held({0.2, 0.2}, 2.0);
  const auto back = held({-0.2, -0.2}, 2.0);
  CHECK(heading_after(out) < 1e-3);
  CHECK_THAT(heading_after(out + back), WithinRel(0.05, 0.1));
  CHECK_THAT(heading_after(out + back + out), WithinRel(0.1, 0.1));
}

TEST_CASE("A drive without a regulator slows down with the battery that the log shows") {
  PlantParameters robot = with("voltage_sag", 0.2);
  GapRunPlan plan;
  plan.charge_used_at_end = 1.0;
  const auto run = drive_plant(robot, held({0.2, 0.2}, 20.0), plan);
  const auto& last = run.log.samples.back();
  CHECK_THAT(run.truth.back().rim_m_s.left / 0.2, WithinRel(*last.battery_v / robot.battery_full_v, 0.01));
  CHECK(run.truth.back().supply < 0.85);
}

TEST_CASE("Lost counts lack in the log while the wheel goes on turning") {
  const auto commands = held({0.2, 0.2}, 30.0);
  const auto counted_m = [&](const PlantParameters& robot) {
    const auto samples = drive_plant(robot, commands, {}).log.samples;
    return robot.metres_per_tick *
           static_cast<double>(samples.back().ticks->left - samples.front().ticks->left);
  };
  const double lost_share = 1.0 - counted_m(with("encoder_dropout", 0.04)) / counted_m(quiet_robot());
  CHECK(lost_share > 0.005);
  CHECK(lost_share < 0.12);
}
