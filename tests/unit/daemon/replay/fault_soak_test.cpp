// Faults of the cable on the virtual clock: the short form of tests/soak/run.
#include "tests/support/catch.hpp"
#include "tests/support/simulated_run.hpp"
#include "tests/support/soak/virtual_soak.hpp"

using namespace wheelwright;

namespace {

soak::SoakConfig soak_of(std::uint64_t seed) {
  soak::SoakConfig config;
  config.robot = test::robot_in_room("default", "empty", seed);
  config.cable.seed = seed;
  return config;
}

void check(const soak::SoakFigures& figures) {
  INFO(soak::to_text(figures));
  const auto found = soak::shortcomings(figures);
  INFO((found.empty() ? "" : found.front()));
  CHECK(found.empty());
}

}  // namespace

TEST_CASE(
    "Whatever the cable does costs samples that it hit, never the count of them, and the link comes back") {
  soak::SoakConfig config = soak_of(GENERATE(11U, 12U));
  config.faults = 150;
  const auto figures = soak::run_virtual_soak(config);
  check(figures);
  CHECK(figures.injected() == 150);
  CHECK(figures.blind_segments > 10);
}

TEST_CASE("By the sensor stream the faults of the cable are survived as well") {
  soak::SoakConfig config = soak_of(13);
  config.link.transport = roomba::Transport::stream;
  config.link.period_s = config.robot.firmware.sensor_update_period_s;
  config.faults = 100;
  check(soak::run_virtual_soak(config));
}
