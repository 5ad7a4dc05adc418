#include "model/filter/environment_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double tick_s = 0.018;

// Straight ahead at first, then turns to either side between ways ahead: each wheel goes backward at times.
WheelPair wanted_at_m_s(double t_s) {
  if (t_s < 13.0) return {0.2, 0.2};
  const double phase_s = std::fmod(t_s, 6.0);
  if (phase_s < 3.0) return {0.2, 0.2};
  return std::fmod(t_s, 12.0) < 6.0 ? WheelPair{0.15, -0.15} : WheelPair{-0.15, 0.15};
}

enum class Currents { are_signed, are_sizes };

// The time at which a robot is told that it is due for another calibration.
std::optional<double> due_at_s(Currents currents, double pull_after_60_s, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  EnvironmentMonitor monitor(tick_s);
  WheelPair speed;
  for (int tick = 0; tick < 10000; ++tick) {
    const double t_s = tick_s * tick;
    const double pull = t_s < 60.0 ? 1.0 : pull_after_60_s;
    DrivingEvidence evidence;
    evidence.received = evidence.sound = true;
    const auto step = [&](double& now, double wanted, double& acceleration, double& current_a) {
      acceleration = std::clamp((wanted - now) / tick_s, -0.5, 0.5);
      now += tick_s * acceleration;
      const double sign = std::clamp(now / 0.01, -1.0, 1.0);
      current_a = pull * (0.08 * sign + 0.1 * now) + 0.2 * acceleration + 0.03 * noise(random);
      if (currents == Currents::are_sizes) current_a = std::abs(current_a);
    };
    const WheelPair wanted = wanted_at_m_s(t_s);
    step(speed.left, wanted.left, evidence.acceleration_m_s2.left, evidence.current_a.left);
    step(speed.right, wanted.right, evidence.acceleration_m_s2.right, evidence.current_a.right);
    evidence.speed_m_s = speed;
    evidence.innovation = {noise(random), noise(random)};
    if (monitor.take(evidence)) return t_s;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("A floor that pulls harder is noticed, whether currents are signed or are sizes") {
  for (const Currents currents : {Currents::are_signed, Currents::are_sizes}) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      INFO("sizes: " << (currents == Currents::are_sizes) << ", seed " << seed);
      CHECK_FALSE(due_at_s(currents, 1.0, seed));
      const auto due_s = due_at_s(currents, 1.6, seed);
      REQUIRE(due_s);
      CHECK(*due_s > 60.0);
      CHECK(*due_s < 90.0);
    }
  }
}
