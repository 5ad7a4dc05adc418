// A stop is obeyed whatever has become of standard error, the terminal, and the limits of the process.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/held_thread.hpp"
#include "tests/loopback/bench/stalled_pipe.hpp"
#include "tests/loopback/bench/terminal.hpp"
#include "tests/loopback/bench/wheel_rest.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr auto long_way = "[[3, 0]]";
constexpr double longest_ms = 300.0;
// Of a sensor loop that hangs, without real-time scheduling: the guardian waits for as long as the robot may
// drive blind.
constexpr double longest_stall_ms = 550.0;

// At exit the thread sanitizer flushes standard error, and waits where nobody reads it.
#ifdef __SANITIZE_THREAD__
constexpr bool exit_needs_a_reader = true;
#else
constexpr bool exit_needs_a_reader = false;
#endif
constexpr auto needs_a_reader = "the thread sanitizer ends no process of which standard error is not read";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// By the status file of a daemon that drives its route straight on: from there it is at full speed.
bool is_under_way(const std::filesystem::path& status_file) {
  const std::string text = text_of(status_file);
  const std::string key = "\"x_m\": ";
  const auto found = text.find(key);
  return text.find("\"phase\": \"route\"") != std::string::npos && found != std::string::npos &&
         std::strtod(text.c_str() + found + key.size(), nullptr) > 0.25;
}

void check_rest(const Table& truth, double from_ms, double limit_ms = longest_ms) {
  const double ms = ms_to_rest(truth, from_ms);
  WARN("wheels at rest after " << std::lround(ms) << " ms");
  CHECK(speed_at(truth, from_ms) > 0.15);
  CHECK(ms < limit_ms);
}

// A robot that drives straight on at 0.2 m/s, by a daemon whose messages nobody reads. What it does is known
// from its status file.
struct UnreadDrive {
  UnreadDrive() {
    REQUIRE(eventually(15s, [this] { return is_under_way(bench.folder() / "status.json"); }));
  }

  bool phase(const std::string& name) const {
    return text_of(bench.folder() / "status.json").find("\"phase\": \"" + name + '"') != std::string::npos;
  }
  double signal(int number) const {
    const double at_ms = unix_ms_now();
    daemon->signal(number);
    return at_ms;
  }
  Table truth() const {
    std::this_thread::sleep_for(500ms);
    robot->end();
    return bench.truth();
  }

  Bench bench;
  StalledPipe nobody{bench.folder() / "stalled"};
  std::unique_ptr<ChildProcess> robot = bench.start_robot("default");
  std::filesystem::path config = bench.configure({.run = "at_end: stay", .route = long_way});
  std::unique_ptr<ChildProcess> daemon = bench.start_daemon(
      config, nobody.as_standard_error(), {"--status", (bench.folder() / "status.json").string()});
};

// The daemon, started by hand in a terminal.
struct TerminalDrive {
  TerminalDrive() {
    REQUIRE(eventually(15s, [this] { return is_under_way(bench.folder() / "status.json"); }));
  }

  Bench bench;
  std::unique_ptr<ChildProcess> robot = bench.start_robot("default");
  Terminal terminal{{WHEELWRIGHTD, "--config", bench.configure({.route = long_way}).string(), "--status",
                     (bench.folder() / "status.json").string()}};
};

}  // namespace

TEST_CASE("SIGTERM is obeyed, and the process ends, while nobody reads standard error") {
  if (exit_needs_a_reader) return skip(needs_a_reader);
  UnreadDrive drive;
  drive.daemon->signal(SIGHUP);  // is refused by a message
  const double at_ms = drive.signal(SIGTERM);
  CHECK(drive.daemon->wait(8s) == 1);
  CHECK_THAT(drive.daemon->out(), ContainsSubstring("Result: stopped, ended by a signal"));
  check_rest(drive.truth(), at_ms);
}

TEST_CASE("SIGUSR2 is obeyed, and the drive log is complete, while nobody reads standard error") {
  if (exit_needs_a_reader) return skip(needs_a_reader);
  UnreadDrive drive;
  drive.daemon->signal(SIGHUP);
  const double at_ms = drive.signal(SIGUSR2);
  REQUIRE(eventually(3s, [&] { return drive.phase("stopped: requested"); }));
  check_rest(drive.truth(), at_ms);
  drive.signal(SIGTERM);
  CHECK(drive.daemon->wait(8s) == 1);
  const Table log = drive.bench.drive_log();
  CHECK(log.number(log.rows() - 1, "cmd_left") == 0.0);
}

TEST_CASE("The guardian stops the wheels of a loop that hangs while nobody reads standard error") {
  UnreadDrive drive;
  const double at_ms = unix_ms_now();
  const HeldThread hung(drive.daemon->pid(), "ww-loop");
  if (!hung) return skip("this system does not let a thread be held");
  std::this_thread::sleep_for(1s);
  check_rest(drive.truth(), at_ms, longest_stall_ms);
}

TEST_CASE(
    "After SIGKILL the guardian stops the wheels and frees the port while nobody reads standard error") {
  UnreadDrive drive;
  const double at_ms = drive.signal(SIGKILL);
  CHECK(drive.daemon->wait(5s) == -SIGKILL);
  const auto next = drive.bench.start_daemon(drive.bench.configure({.run = "arm: by_signal"}));
  CHECK(next->says("the robot answers", 8s));
  check_rest(drive.truth(), at_ms);
}

TEST_CASE("SIGTERM is obeyed, and the process ends, while the terminal is held by Ctrl-S") {
  if (exit_needs_a_reader) return skip(needs_a_reader);
  TerminalDrive drive;
  drive.terminal.hold_output();
  ::kill(drive.terminal.pid(), SIGUSR1);  // is answered by a message
  std::this_thread::sleep_for(200ms);
  const double at_ms = unix_ms_now();
  ::kill(drive.terminal.pid(), SIGTERM);
  CHECK(drive.terminal.wait(10s) == 1);
  drive.robot->end();
  check_rest(drive.bench.truth(), at_ms);
}

TEST_CASE("The guardian stops the wheels of a loop that hangs while the terminal is held by Ctrl-S") {
  TerminalDrive drive;
  drive.terminal.hold_output();
  const double at_ms = unix_ms_now();
  const HeldThread hung(drive.terminal.pid(), "ww-loop");
  if (!hung) return skip("this system does not let a thread be held");
  std::this_thread::sleep_for(1500ms);
  drive.robot->end();
  check_rest(drive.bench.truth(), at_ms, longest_stall_ms);
}

TEST_CASE("A daemon whose terminal is closed stops the robot and ends") {
  TerminalDrive drive;
  const double at_ms = unix_ms_now();
  drive.terminal.close();
  CHECK(drive.terminal.wait(8s) == 1);
  drive.robot->end();
  check_rest(drive.bench.truth(), at_ms);
  const Table log = drive.bench.drive_log();
  CHECK(log.number(log.rows() - 1, "cmd_left") == 0.0);
}

TEST_CASE("Under a limit of file size the route is driven to its end, and the file is named") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon =
      bench.start_daemon(bench.configure({}), {"sh", "-c", "ulimit -f 16; exec \"$@\"", "sh"});
  CHECK(daemon->wait(20s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: finished"));
  CHECK_THAT(daemon->err(), ContainsSubstring("_log.csv: cannot be written: File too large"));
}

TEST_CASE("A limit of processor time ends the run in order, with a sentence") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  const auto daemon = bench.start_daemon(bench.configure({.route = long_way}));
  REQUIRE(daemon->says("route: driving", 15s));
  std::this_thread::sleep_for(1500ms);
  const double at_ms = unix_ms_now();
  daemon->signal(SIGXCPU);
  CHECK(daemon->wait(5s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("a limit of processor time is reached"));
  robot->end();
  check_rest(bench.truth(), at_ms);
}

TEST_CASE("With too few threads the daemon does not start, says why, and leaves the robot alone") {
  if (::geteuid() != 0) return skip("only root can give a process a user without other processes");
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  std::filesystem::permissions(bench.folder(), std::filesystem::perms::all);
  std::filesystem::permissions(bench.device(), std::filesystem::perms::all);
  const auto config = bench.configure({});
  for (const int threads : {1, 2, 3, 4, 5, 6}) {
    CAPTURE(threads);
    const auto daemon =
        bench.start_daemon(config, {"setpriv", "--reuid=64213", "--regid=64213", "--clear-groups", "prlimit",
                                    "--nproc=" + std::to_string(threads), "--"});
    CHECK(daemon->wait(10s) == 1);
    CHECK_THAT(daemon->err(), ContainsSubstring("raise the limit of"));
  }
  robot->end();
  CHECK(travel_of(bench.truth()).left_m == 0.0);
}
