// Bytes to the simulated robot: whatever they say, its physics stay physics.
#include "drivers/simulation/simulated_robot.hpp"

#include <array>
#include <cmath>

#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const simulation::SimulationConfig config;
  simulation::SimulatedRobot robot(config);
  constexpr std::size_t max_bytes = 2000;  // the physics take their time
  size = std::min(size, max_bytes);
  std::array<std::uint8_t, 512> sent{};
  for (std::size_t i = 0; i < size;) {
    const std::size_t count = std::min<std::size_t>(size - i, 1U + data[i] % 40U);
    robot.receive({data + i, count});
    robot.advance(std::chrono::milliseconds(5));
    robot.transmit(sent);
    i += count;
  }
  const auto truth = robot.truth();
  fuzz::must_hold(std::isfinite(truth.pose.x_m) && std::isfinite(truth.pose.theta_rad),
                  "the pose is a number");
  fuzz::must_hold(std::abs(truth.v_m_s) < 1.0, "no Roomba drives faster");
  return 0;
}
