// What the guardian's process writes to a port that is given up.
#include "daemon/guardian/guardian_handle.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>
#include <vector>

#include "drivers/roomba/rest_bytes.hpp"
#include "drivers/simulation/pseudo_terminal.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace std::chrono_literals;

namespace {

// Of the robot's end, up to `count` bytes, or what has come after two seconds.
std::vector<std::uint8_t> received(simulation::PseudoTerminal& robot, std::size_t count) {
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 256> part{};
  for (int i = 0; i < 200 && bytes.size() < count; ++i) {
    bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(robot.read(part)));
    std::this_thread::sleep_for(10ms);
  }
  return bytes;
}

struct GuardedPort {
  simulation::PseudoTerminal robot;
  int port = ::open(robot.path().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  daemon::GuardianHandle guardian{daemon::GuardianConfig{}};

  GuardedPort() { guardian.port_opened(port); }
  ~GuardedPort() { ::close(port); }
  GuardedPort(const GuardedPort&) = delete;
  GuardedPort& operator=(const GuardedPort&) = delete;
};

}  // namespace

TEST_CASE("A port that is given up while the robot may drive gets the order to stand") {
  GuardedPort guarded;
  guarded.guardian.port_dropped();
  const auto order = roomba::rest_bytes(roomba::DriveMode::direct);
  const std::vector<std::uint8_t> wanted(order.bytes().begin(), order.bytes().end());
  CHECK(received(guarded.robot, wanted.size()) == wanted);
}

TEST_CASE("A port that is closed in order is left alone") {
  GuardedPort guarded;
  guarded.guardian.port_closed();
  std::this_thread::sleep_for(200ms);
  std::array<std::uint8_t, 16> bytes{};
  CHECK(guarded.robot.read(bytes) == 0);
}
