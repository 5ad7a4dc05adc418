// The default robot against what a real Create 2 does: dead time 31 to 47 ms, rise about 110 ms, at
// most 20 % overshoot, stopped after 125 to 140 ms, everything over before 270 ms.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;

namespace {

struct Response {
  double dead_ms = 0.0;
  double rise_ms = 0.0;  // from the command to 90 %
  double overshoot = 0.0;
  double settled_ms = 0.0;  // within 10 % from then on
  double stopped_ms = 0.0;  // below 5 % from then on
};

Response respond(int speed_mm_s, std::chrono::nanoseconds phase) {
  auto config = shipped_robot("default.yaml");
  config.room.obstacles.clear();
  Host host(config);
  host.start();
  host.robot.advance(1s + phase);
  host.drive(speed_mm_s, speed_mm_s);
  std::vector<double> speeds;
  for (int ms = 0; ms < 1000; ++ms) {
    host.robot.advance(1ms);
    speeds.push_back(1000.0 * host.robot.truth().v_m_s / speed_mm_s);
  }
  Response response;
  for (std::size_t ms = 0; ms < speeds.size(); ++ms) {
    const auto time = static_cast<double>(ms + 1);
    if (response.dead_ms == 0.0 && speeds[ms] > 0.05) response.dead_ms = time;
    if (response.rise_ms == 0.0 && speeds[ms] > 0.9) response.rise_ms = time;
    response.overshoot = std::max(response.overshoot, speeds[ms] - 1.0);
    if (std::abs(speeds[ms] - 1.0) > 0.1) response.settled_ms = time;
  }
  host.drive(0, 0);
  for (int ms = 1; ms <= 500; ++ms) {
    host.robot.advance(1ms);
    if (std::abs(1000.0 * host.robot.truth().v_m_s / speed_mm_s) > 0.05) response.stopped_ms = ms;
  }
  return response;
}

}  // namespace

TEST_CASE("The default robot answers a step like a Create 2") {
  const int speed_mm_s = GENERATE(78, 149, 199, 300, -149);
  const auto phase = GENERATE(0ms, 5ms, 11ms);
  CAPTURE(speed_mm_s, phase.count());
  const Response response = respond(speed_mm_s, phase);
  CHECK(response.dead_ms >= 18.0);
  CHECK(response.dead_ms <= 52.0);  // seen in the motion itself, not in sensor refreshes
  CHECK(response.rise_ms >= 80.0);
  CHECK(response.rise_ms <= 140.0);
  CHECK(response.overshoot <= 0.2);
  CHECK(response.settled_ms <= 270.0);
  CHECK(response.stopped_ms >= 70.0);
  CHECK(response.stopped_ms <= 140.0);
}

TEST_CASE("On the Create 2 commands act in steps of one count per tick, and the smallest not at all") {
  const auto speed_of = [](int speed_mm_s) {
    auto config = shipped_robot("create2.yaml");
    Host host(config);
    host.start();
    host.drive(speed_mm_s, speed_mm_s);
    host.robot.advance(2s);
    const double x_m = host.robot.truth().pose.x_m;
    host.robot.advance(2s);
    return 1000.0 * (host.robot.truth().pose.x_m - x_m) / 2.0;
  };
  CHECK_THAT(speed_of(10), WithinAbs(0.0, 0.1));
  CHECK_THAT(speed_of(11), WithinAbs(28.5, 1.5));
  CHECK_THAT(speed_of(38), WithinAbs(28.5, 1.5));
  CHECK_THAT(speed_of(40), WithinAbs(56.9, 1.5));
  CHECK_THAT(speed_of(98), WithinAbs(113.8, 1.5));
}
