// Commands that are as given: what a gap analysis wants to know next is a drive of the daemon.
#include "config/load/drive_log_file.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr auto both_ways_round =
    "# wheelwright_drive_log: 1\n# wheel_base_m: 0.235\n# period_s: 0.5\nt,cmd_left,cmd_right\n"
    "0,0,0\n0.5,0.12,-0.05\n1,0.12,-0.05\n1.5,-0.05,0.12\n2,-0.05,0.12\n2.5,0,0\n";

std::unique_ptr<ChildProcess> start_with_commands(const Bench& bench, const std::filesystem::path& config,
                                                  const std::filesystem::path& commands) {
  return std::make_unique<ChildProcess>(
      std::vector<std::string>{WHEELWRIGHTD, "--config", config.string(), "--commands", commands.string()},
      bench.folder() / "daemon_said");
}

}  // namespace

TEST_CASE("The daemon drives the commands of a log instead of its route, and its own log has them again") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto commands = bench.write("next.csv", both_ways_round);
  const auto daemon = start_with_commands(bench, bench.configure({}), commands);
  REQUIRE(daemon->wait(30s) == 0);
  CHECK_THAT(daemon->out(), ContainsSubstring("Commands of 'next.csv', as given"));

  const Table log = bench.drive_log();
  int one_way = 0;
  int other_way = 0;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.word(row, "activity") != "commanded_drive") continue;
    one_way += log.number(row, "cmd_left") == 0.12 && log.number(row, "cmd_right") == -0.05 ? 1 : 0;
    other_way += log.number(row, "cmd_left") == -0.05 && log.number(row, "cmd_right") == 0.12 ? 1 : 0;
  }
  CHECK(one_way == 55);  // one second, and the change at the nearest tick
  CHECK(other_way == 56);
  // What it recorded is a run like any other.
  CHECK(wheelwright::config::load_drive_log(bench.runs().back() / "drive_log.csv").has_ticks());

  ChildProcess replay({WHEELWRIGHT, "replay", (bench.runs().back() / "drive_log.csv").string()},
                      bench.folder() / "replay");
  CHECK(replay.wait(30s) == 0);
  CHECK_THAT(replay.out(), ContainsSubstring("the same to the byte"));
}

TEST_CASE("Commands that are too fast are refused whole before anything moves") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto commands = bench.write("next.csv",
                                    "# wheelwright_drive_log: 1\n# wheel_base_m: 0.235\n# period_s: 0.5\n"
                                    "t,cmd_left,cmd_right\n0,0.1,0.1\n0.5,0.1,-0.35\n1,0,0\n");
  const auto daemon = start_with_commands(bench, bench.configure({}), commands);
  CHECK(daemon->wait(10s) == 2);
  CHECK_THAT(daemon->err(), ContainsSubstring("next.csv:6: commands 0.35 m/s"));
  CHECK_FALSE(std::filesystem::exists(bench.folder() / "runs"));
}
