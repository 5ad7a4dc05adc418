// The daemon as a service manager sees it: notifications, watchdog, reload, exit status.
#include <unistd.h>
#include <algorithm>

#include <csignal>
#include <fstream>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/held_thread.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/loopback/bench/notify_socket.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// A service on the bench: runtime folder, notification socket, a watchdog of one second.
struct ServiceBench : Bench {
  std::unique_ptr<ChildProcess> start_service(const std::filesystem::path& config,
                                              const std::vector<std::string>& options = {}) const {
    std::filesystem::create_directory(runtime());
    std::filesystem::create_directory(state());
    return start_in(config, state(), options);
  }

  // Without making the folders of the service.
  std::unique_ptr<ChildProcess> start_in(const std::filesystem::path& config,
                                         const std::filesystem::path& state_folder,
                                         const std::vector<std::string>& options = {}) const {
    std::vector<std::string> command{"env", "NOTIFY_SOCKET=" + manager_name,
                                     "RUNTIME_DIRECTORY=" + runtime().string(),
                                     "STATE_DIRECTORY=" + state_folder.string(), "WATCHDOG_USEC=1000000"};
    command.insert(command.end(), {WHEELWRIGHTD, "--service", "--config", config.string()});
    command.insert(command.end(), options.begin(), options.end());
    return std::make_unique<ChildProcess>(command, folder() / "daemon_said");
  }

  std::filesystem::path runtime() const { return folder() / "runtime"; }
  std::filesystem::path state() const { return folder() / "state"; }

  NotifySocket manager;
  std::string manager_name = manager.name();
};

const std::string stays = "at_end: stay, arm: by_signal";

int status_of(ServiceBench& bench, const std::filesystem::path& config) {
  return bench.start_service(config)->wait(8s);
}

}  // namespace

TEST_CASE("A service is ready once the robot answers, and not before") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  robot->signal(SIGUSR1);  // its battery is out
  const auto daemon = bench.start_service(bench.configure({.run = stays}));
  REQUIRE(bench.manager.hears("STATUS=waiting for the robot", 10s));
  CHECK_FALSE(bench.manager.hears("READY=1", 1s));
  robot->signal(SIGUSR1);
  CHECK(bench.manager.hears("READY=1", 10s));
  CHECK(bench.manager.hears("STATUS=standing, not armed; pose", 10s));
  CHECK(daemon->end() == 0);
  CHECK(bench.manager.hears("STOPPING=1", 1s));
}

TEST_CASE("The watchdog is fed at least twice in its time, and starves once the sensor loop hangs") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_service(bench.configure({.run = stays}));
  REQUIRE(bench.manager.hears("READY=1", 5s));
  const auto fed_before = bench.manager.count_of("WATCHDOG=1");
  std::this_thread::sleep_for(2s);
  const auto fed = bench.manager.count_of("WATCHDOG=1") - fed_before;
  CHECK(fed >= 4);
  const HeldThread hung(daemon->pid(), "ww-loop");
  if (!hung) return skip("this system does not let a thread be held");
  std::this_thread::sleep_for(500ms);
  const auto fed_at_the_hang = bench.manager.count_of("WATCHDOG=1");
  std::this_thread::sleep_for(1500ms);
  CHECK(bench.manager.count_of("WATCHDOG=1") == fed_at_the_hang);
}

TEST_CASE(
    "A changed configuration is loaded again under a robot that stands, a mistake or a drive refuses it") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({.run = stays, .route = "[[3, 0]]"});
  const auto daemon = bench.start_service(config);
  REQUIRE(bench.manager.hears("READY=1", 5s));

  const std::string good = [&] {
    std::ifstream file(config);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  std::ofstream(config) << good << "lnik: {}\n";
  daemon->signal(SIGHUP);
  const auto wrong_line = std::ranges::count(good, '\n') + 1;
  CHECK(daemon->says("not reloaded: " + config.string() + ":" + std::to_string(wrong_line) + ":1", 2s));
  std::ofstream(config) << good << "robot: {name: renamed}\n";
  daemon->signal(SIGHUP);
  CHECK(daemon->says("loaded again", 3s));
  REQUIRE(eventually(5s, [&] { return bench.runs().size() == 2; }));
  std::this_thread::sleep_for(1s);
  daemon->signal(SIGUSR1);
  REQUIRE(daemon->says("route: driving", 5s));
  std::this_thread::sleep_for(500ms);
  daemon->signal(SIGHUP);
  CHECK(daemon->says("not reloaded: the robot drives", 2s));
  CHECK(daemon->end() == 0);
  CHECK(bench.drive_log().metadata("robot") == "renamed");
}

TEST_CASE("As a service the exit status tells configuration, permission, device, and robot apart") {
  ServiceBench bench;
  const auto good = bench.configure({});
  CHECK(status_of(bench, good) == 69);
  CHECK(status_of(bench, bench.write("wrong.yaml", "lnik: {}\n")) == 78);
  CHECK(bench.start_service(good, {"--no-such-option"})->wait(5s) == 64);
  const auto robot = bench.start_robot("perfect");
  const auto required = bench.write(
      "required.yaml",
      "link: {device: " + bench.device().string() +
          "}\nreal_time: {policy: require}\nrun: {log_folder: " + (bench.folder() / "runs").string() + "}\n");
  const auto unlimited = bench.start_service(required);
  const int status = unlimited->wait(1s);
  CHECK((status == 77 || status == ChildProcess::still_running));  // by what this system grants
  unlimited->end();
  std::filesystem::remove(bench.state() / "hold");  // it was armed
  {
    const auto config = bench.configure({.run = "at_end: exit", .route = "[[3, 0]]"});
    const auto daemon = bench.start_service(config);
    REQUIRE(daemon->says("route: driving", 10s));
    CHECK(status_of(bench, config) == 75);
    robot->signal(SIGUSR1);
    CHECK(daemon->wait(5s) == 76);
    CHECK(
        std::filesystem::exists(bench.runtime() / "rest.yaml"));  // for --rest: nobody has stopped the wheels
  }
}

TEST_CASE("A service that takes over from one that was killed while driving does not drive off by itself") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({.run = "at_end: stay", .route = "[[3, 0]]"});
  const auto first = bench.start_service(config);
  REQUIRE(first->says("route: driving", 10s));
  first->signal(SIGKILL);
  CHECK(first->wait(5s) == -SIGKILL);
  const auto second = bench.start_service(config);
  CHECK(second->says("not armed: the process before this one ended while the robot was armed", 6s));
  CHECK_FALSE(second->says("route: driving", 1s));
  second->signal(SIGUSR1);
  CHECK(second->says("route: driving", 5s));
  CHECK(second->end() == 0);
}

TEST_CASE("A service that was killed while driving does not drive off by itself after a power cut") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({.run = "at_end: stay", .route = "[[3, 0]]"});
  const auto first = bench.start_service(config);
  REQUIRE(first->says("route: driving", 10s));
  first->signal(SIGKILL);
  CHECK(first->wait(5s) == -SIGKILL);
  std::filesystem::remove_all(bench.runtime());  // all that a reboot forgets
  const auto second = bench.start_service(config);
  CHECK(second->says("not armed: the process before this one ended while the robot was armed", 6s));
  CHECK_FALSE(second->says("route: driving", 1s));
  CHECK(second->end() == 0);
}

TEST_CASE("A service that was ended in mid-drive does not drive off by itself, one that had finished does") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto far = bench.configure({.run = "at_end: stay", .route = "[[3, 0]]"});
  const auto first = bench.start_service(far);
  REQUIRE(first->says("route: driving", 10s));
  CHECK(std::filesystem::exists(bench.runtime() / "rest.yaml"));
  CHECK(first->end() == 0);
  CHECK_FALSE(std::filesystem::exists(bench.runtime() / "rest.yaml"));  // the robot was left at rest
  const auto second = bench.start_service(bench.configure({.run = "at_end: stay", .route = "[[0.1, 0]]"}));
  CHECK(second->says("not armed: the process before this one ended while the robot was armed", 6s));
  second->signal(SIGUSR1);
  REQUIRE(second->says("finished", 10s));
  CHECK(second->end() == 0);
  const auto third = bench.start_service(far);
  CHECK(third->says("route: driving", 10s));
}

TEST_CASE(
    "A service that was armed when its adapter was unplugged does not drive off when it is plugged in") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto config = bench.configure({.device = "tapped", .run = "at_end: stay", .route = "[[3, 0]]"});
  const auto first = bench.start_service(config);
  REQUIRE(first->says("route: driving", 10s));
  tap.pull_out();
  REQUIRE(first->says("link lost", 3s));
  CHECK(first->end() == 0);
  tap.put_in();
  const auto second = bench.start_service(config);
  CHECK(second->says("not armed: the process before this one ended while the robot was armed", 6s));
}

TEST_CASE("A service that cannot remember that the robot was armed does not arm it") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  std::filesystem::create_directory(bench.runtime());
  const auto daemon =
      bench.start_in(bench.configure({.run = "at_end: stay"}), bench.folder() / "no_such_folder");
  CHECK(daemon->says("not armed: " + (bench.folder() / "no_such_folder/hold").string(), 8s));
  daemon->signal(SIGUSR1);
  CHECK_FALSE(daemon->says("armed: the robot obeys", 1s));
  CHECK(daemon->end() == 0);
}

TEST_CASE("After an upgrade of the package a service does not drive off by itself") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  std::filesystem::create_directory(bench.state());
  std::ofstream(bench.state() / "hold") << "the package was upgraded\n";
  const auto daemon = bench.start_service(bench.configure({.run = "at_end: stay"}));
  CHECK(daemon->says("not armed: the package was upgraded; SIGUSR1 arms the robot", 8s));
  CHECK_FALSE(daemon->says("route: driving", 1s));
}

TEST_CASE("The option --rest stops the robot though the configuration was spoiled since the start") {
  for (const std::string mistake : {"lnik: {}\n", "run: {route: gone.yaml}\n", "\t[\n"}) {
    CAPTURE(mistake);
    ServiceBench bench;
    const auto robot = bench.start_robot("default");
    const auto config = bench.configure({.run = "at_end: stay", .route = "[[3, 0]]"});
    const auto daemon = bench.start_service(config);
    REQUIRE(daemon->says("route: driving", 10s));
    std::this_thread::sleep_for(1s);
    const auto guardian = daemon->child();
    if (!guardian) return skip("this kernel does not tell the children of a process");
    ::kill(*guardian, SIGKILL);
    daemon->signal(SIGKILL);
    std::ofstream(config) << mistake;
    std::filesystem::remove(bench.folder() / "route.yaml");
    CHECK(bench.start_service(config, {"--rest"})->wait(5s) == 0);
    robot->end();
    const Table truth = bench.truth();
    CHECK(std::abs(truth.number(truth.rows() - 1, "speed_left")) < 0.001);
  }
}

TEST_CASE("The option --rest stops a robot whose daemon and guardian are both gone") {
  struct Case {
    std::vector<std::string> how_it_ended;
    bool stops;
    bool farewell_is_missing = false;
  };
  const auto [how_it_ended, stops, farewell_is_missing] =
      GENERATE(values<Case>({{{}, true},
                             {{"EXIT_CODE=killed", "EXIT_STATUS=KILL"}, true},
                             {{"EXIT_CODE=exited", "EXIT_STATUS=70"}, true},  // a sensor loop that hangs
                             {{"EXIT_CODE=exited", "EXIT_STATUS=76"}, true},  // the robot was lost
                             {{"EXIT_CODE=exited", "EXIT_STATUS=0"}, true, true},
                             {{"EXIT_CODE=exited", "EXIT_STATUS=75"}, false, true},  // it is another's
                             {{"EXIT_CODE=exited", "EXIT_STATUS=0"}, false}}));
  CAPTURE(how_it_ended, farewell_is_missing);
  ServiceBench bench;
  std::filesystem::create_directory(bench.runtime());
  if (farewell_is_missing) std::ofstream(bench.runtime() / "rest.yaml") << "\n";
  const auto robot = bench.start_robot("default");
  const auto config = bench.configure({});
  {
    LineTap tap(bench.device(), bench.folder() / "tapped");
    tap.tell_robot(std::vector<std::uint8_t>{128, 131, 145, 0, 200, 0, 200});
    std::this_thread::sleep_for(700ms);
  }
  std::vector<std::string> command{"/usr/bin/env"};
  command.push_back("RUNTIME_DIRECTORY=" + bench.runtime().string());
  command.insert(command.end(), how_it_ended.begin(), how_it_ended.end());
  for (const char* word : {WHEELWRIGHTD, "--service", "--rest", "--config"}) command.emplace_back(word);
  command.push_back(config.string());
  const auto rest = std::make_unique<ChildProcess>(command, bench.folder() / "rest_said");
  CHECK(rest->wait(5s) == 0);
  robot->end();
  const Table truth = bench.truth();
  double fastest = 0.0;
  for (std::size_t row = 0; row < truth.rows(); ++row) {
    fastest = std::max(fastest, truth.number(row, "speed_left"));
  }
  CHECK(fastest > 0.15);
  CHECK((std::abs(truth.number(truth.rows() - 1, "speed_left")) < 0.001) == stops);
}

TEST_CASE("wheelwright status tells a running daemon from one that is gone") {
  ServiceBench bench;
  const auto robot = bench.start_robot("perfect");
  const auto daemon = bench.start_service(bench.configure({.run = stays}));
  REQUIRE(bench.manager.hears("STATUS=standing", 5s));
  const auto asked = [&](const std::string& option) {
    return std::make_unique<ChildProcess>(
        std::vector<std::string>{WHEELWRIGHT, "status", (bench.folder() / "runtime/status.json").string(),
                                 option},
        bench.folder() / "status_said");
  };
  const auto running = asked("--json");
  CHECK(running->wait(2s) == 0);
  CHECK_THAT(running->out(), ContainsSubstring("\"phase\": \"standing, not armed\""));
  CHECK_THAT(running->out(), ContainsSubstring("\"histogram\""));
  daemon->signal(SIGKILL);
  daemon->wait(2s);
  const auto gone = asked("--json");
  CHECK(gone->wait(2s) == 1);
  CHECK_THAT(gone->err(), ContainsSubstring("does not run any more"));
}
