// The calibration that never ends, in the real daemon: a robot drives laps by a model that is wrong.
#include "config/load/model_file.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/outdated_model.hpp"

using namespace wheelwright::bench;

TEST_CASE("A better model takes over while the robot drives: no command is late, and replay repeats it") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  std::string route;
  for (const auto& corner : wheelwright::test::laps(7)) {
    route +=
        (route.empty() ? "[[" : ", [") + std::to_string(corner.x_m) + ", " + std::to_string(corner.y_m) + "]";
  }
  const auto config = bench.configure({.route = route + "]", .speed_m_s = 0.25});
  const auto file = bench.folder() / "model.yaml";
  wheelwright::config::save_model(wheelwright::test::scaled(wheelwright::config::load_model(file), 0.9),
                                  file);

  const auto daemon = bench.start_daemon(config);
  REQUIRE(daemon->wait(150s) == 0);
  CHECK_THAT(daemon->out(), ContainsSubstring("commands late               0"));
  const auto run = bench.runs().back();
  REQUIRE(std::filesystem::exists(run / "model-2.yaml"));
  const auto adapted = wheelwright::config::load_model(run / "model-2.yaml");
  CHECK_THAT(adapted.source.back(), ContainsSubstring("run " + run.filename().string() + ", version 2"));
  CHECK_THAT(wheelwright::dc_gain(adapted.core.left).from_left, WithinAbs(1.0, 0.05));

  ChildProcess replay({WHEELWRIGHT, "replay", (run / "drive_log.csv").string()}, run / "replay");
  CHECK(replay.wait(60s) == 0);
  CHECK_THAT(replay.out(), ContainsSubstring("the same to the byte"));
}
