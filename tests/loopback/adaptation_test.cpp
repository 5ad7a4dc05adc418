// The calibration that does not end, in the real daemon: laps by a model that has become wrong.
#include <csignal>

#include "config/load/model_file.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/outdated_model.hpp"

using namespace wheelwright::bench;

namespace {

std::string many_laps() {
  std::string points;
  for (const auto& corner : wheelwright::test::laps(30)) {
    points +=
        (points.empty() ? "[" : ", [") + std::to_string(corner.x_m) + ", " + std::to_string(corner.y_m) + "]";
  }
  return "[" + points + "]";
}

// The first row where the column is as wanted; the number of rows where there is none.
std::size_t first_row(const Table& log, const std::string& column, const std::string& wanted) {
  std::size_t row = 0;
  while (row < log.rows() && log.word(row, column) != wanted) ++row;
  return row;
}

// Are there commands for each tick of the 200 around a row?
bool without_hole(const Table& log, std::size_t context) {
  for (std::size_t row = context - 100; row < context + 100; ++row) {
    if (log.number(row, "tick") != log.number(row - 1, "tick") + 1.0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("A better model takes over while the robot drives, no command is late, and replay repeats it") {
  Bench bench;
  const auto robot = bench.start_robot(
      "default", "room: " + std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/robots/rooms/empty.yaml\n");
  // A busy machine may keep the simulated robot from answering for a while; that is no part of this test.
  const auto config = bench.configure({.link = "blind_limit_s: 3, lost_after_s: 6",
                                       .calibration = "when: never, adapt: true",
                                       .route = many_laps(),
                                       .speed_m_s = 0.25});
  const auto file = bench.folder() / "model.yaml";
  const auto wrong = wheelwright::test::scaled(wheelwright::config::load_model(file), 0.9);
  wheelwright::config::save_model(wrong, file);

  const auto daemon = bench.start_daemon(config);
  REQUIRE(daemon->says("route: driving", 30s));
  const auto run = bench.runs().back();
  const auto adapted_file = run / "model-2.yaml";
  const bool adapted = eventually(240s, [&] { return std::filesystem::exists(adapted_file); });
  INFO(daemon->out() << daemon->err());
  REQUIRE(adapted);
  // Some seconds more, by the new model: a row is over a hundred bytes long.
  const auto drive_log = run / "drive_log.csv";
  const auto so_far = std::filesystem::file_size(drive_log);
  REQUIRE(eventually(60s, [&] { return std::filesystem::file_size(drive_log) > so_far + 60000; }));
  daemon->signal(SIGTERM);
  REQUIRE(daemon->wait(20s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, ended by a signal"));

  const Table log = bench.drive_log();
  const std::size_t exchanged = first_row(log, "model_version", "2");
  const std::size_t due = first_row(bench.pose_log(), "recalibration_due", "1");
  CHECK(due < exchanged);
  REQUIRE(exchanged + 100 < log.rows());
  CHECK(log.word(exchanged, "activity") == "route");
  if (daemon->says("SCHED_FIFO", 0ms)) {  // else any busy machine delays the loop
    CHECK(without_hole(log, exchanged));
    CHECK_THAT(daemon->out(), ContainsSubstring("commands late               0"));
  }
  const auto model = wheelwright::config::load_model(adapted_file);
  CHECK_THAT(model.source.back(), ContainsSubstring("run " + run.filename().string() + ", version 2"));
  CHECK_THAT(wheelwright::dc_gain(model.linear_part.left).from_left, WithinAbs(1.0, 0.05));

  ChildProcess replay({WHEELWRIGHT, "replay", (run / "drive_log.csv").string()}, run / "replay");
  CHECK(replay.wait(120s) == 0);
  CHECK_THAT(replay.out(), ContainsSubstring("the same to the byte"));
}
