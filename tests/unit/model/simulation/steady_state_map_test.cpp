// Which command makes a wheel settle at which speed, where the curve is no line.
#include "model/simulation/steady_state_map.hpp"

#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;

// Of wheels that have a lag of 40 ms and a gain of one.
SteadyStateMap map_with(const std::vector<EffectSetting>& effects) {
  const double share = -std::expm1(-period_s / 0.04);
  const LinearModel linear_part{
      ModelType::arma, period_s, 0.235, {{share}, {0.0}, {1.0 - share}}, {{0.0}, {share}, {1.0 - share}}};
  return {linear_part, effects};
}

double left_command_m_s(const SteadyStateMap& map, double speed_m_s) {
  return map.command_for({speed_m_s, 0.1}).left;
}

}  // namespace

TEST_CASE("Where commands act in steps, a wheel gets the command in the middle of a step") {
  constexpr double step_m_s = 0.03;
  const double resolution_m_s = 0.004;  // of the curve
  for (const double rises_at : {0.5, 1.0, 0.2}) {
    const SteadyStateMap map = map_with({{"command_quantization", "", {step_m_s, rises_at}}});
    for (const double speed_m_s : {0.05, 0.1, 0.137, -0.05, -0.2}) {
      const double level = std::round(std::abs(speed_m_s) / step_m_s);
      const double middle_m_s = step_m_s * (level + rises_at - 0.5);
      INFO(speed_m_s << " m/s, rises at " << rises_at);
      CHECK_THAT(left_command_m_s(map, speed_m_s),
                 WithinAbs(std::copysign(middle_m_s, speed_m_s), resolution_m_s));
    }
  }
}

TEST_CASE("A wheel whose slowest motion is more than twice as fast as wanted is told to stand") {
  const SteadyStateMap map = map_with({{"command_quantization", "", {0.06, 0.5}}});
  CHECK(left_command_m_s(map, 0.02) == 0.0);
  CHECK(left_command_m_s(map, -0.02) == 0.0);
  CHECK(left_command_m_s(map, 0.0) == 0.0);
}

TEST_CASE("Where speeds follow commands without steps, each wheel gets the speed that was asked for") {
  const SteadyStateMap map = map_with({{"coulomb_friction", "", {0.01, 0.04}}});
  for (const double speed_m_s : {0.05, 0.1, -0.15}) {
    CHECK_THAT(left_command_m_s(map, speed_m_s), WithinAbs(speed_m_s + std::copysign(0.01, speed_m_s), 1e-3));
  }
}

TEST_CASE("Beyond saturation a wheel gets a command close to the edge, where it acts in steps too") {
  constexpr double step_m_s = 0.03;
  // The sixth step is 0.18 m/s, and begins at 0.165 m/s.
  const SteadyStateMap map =
      map_with({{"command_quantization", "", {step_m_s, 0.5}}, {"saturation", "speed", {0.171, 0.0, 0.0}}});
  for (const double way : {1.0, -1.0}) {
    const double command_m_s = way * left_command_m_s(map, way * 0.168);
    CHECK(command_m_s > 0.17);
    CHECK(command_m_s < 0.19);
  }
  CHECK_THAT(left_command_m_s(map, 0.155), WithinAbs(0.15, 0.004));
}
