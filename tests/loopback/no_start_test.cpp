// What keeps the daemon from starting: it says so in one line, exits with 2, and moves nothing.
#include <unistd.h>
#include <algorithm>
#include <fstream>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

std::string refusal_of(ChildProcess& daemon) {
  CHECK(daemon.wait(5s) == 2);
  CHECK(daemon.out().empty());
  const std::string said = daemon.err();
  CAPTURE(said);
  CHECK(std::count(said.begin(), said.end(), '\n') == 1);
  return said;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("A device that is not there is named") {
  Bench bench;
  const auto daemon = bench.start_daemon(bench.configure({}));
  const std::string said = refusal_of(*daemon);
  CHECK_THAT(said, ContainsSubstring(bench.device().string() + ": no such device"));
}

TEST_CASE("A file that is no serial port is named") {
  Bench bench;
  bench.write("robot", "precious\n");
  const auto daemon = bench.start_daemon(bench.configure({}));
  CHECK_THAT(refusal_of(*daemon), ContainsSubstring("cannot be opened as a serial port"));
  CHECK(text_of(bench.device()) == "precious\n");
}

TEST_CASE("A device without permission is named, with the remedy") {
  if (::geteuid() != 0) return skip("only root can make a device that the daemon may not open");
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({});
  std::filesystem::permissions(bench.folder(), std::filesystem::perms::all);
  const auto nobody = {std::string("setpriv"), std::string("--reuid=65534"), std::string("--regid=65534"),
                       std::string("--clear-groups")};
  const auto daemon = bench.start_daemon(config, nobody);
  const std::string said = refusal_of(*daemon);
  CHECK_THAT(said, ContainsSubstring(": no permission"));
  CHECK_THAT(said, ContainsSubstring("dialout"));
}

TEST_CASE("A folder for logs that cannot be made is named, with its key") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({});
  std::string text = text_of(config);
  const auto key = text.find("log_folder: ");
  REQUIRE(key != std::string::npos);
  text.replace(key, text.find_first_of(",}\n", key) - key, "log_folder: /proc/x");
  const auto daemon = bench.start_daemon(bench.write("nowhere.yaml", text));
  const std::string said = refusal_of(*daemon);
  CHECK_THAT(said,
             ContainsSubstring("nowhere.yaml: log_folder: /proc/x/") && ContainsSubstring("cannot be made"));
}

TEST_CASE("A second daemon on the same robot is refused, and the first drives on") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const auto config = bench.configure({});
  const auto first = bench.start_daemon(config);
  REQUIRE(first->says("route: driving", 10s));
  const auto second = std::make_unique<ChildProcess>(
      std::vector<std::string>{WHEELWRIGHTD, "--config", config.string()}, bench.folder() / "second_said");
  CHECK_THAT(refusal_of(*second), ContainsSubstring("in use by wheelwrightd (process "));
  CHECK_FALSE(first->says("stopped", 300ms));
  CHECK(first->wait(0ms) == ChildProcess::still_running);
}

TEST_CASE(
    "A mistake in the configuration is told with file, line and column, and no byte goes to the robot") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto good = bench.configure({.device = "tapped"});
  const auto refused = [&](const std::string& name, const std::string& text) {
    const auto daemon = bench.start_daemon(bench.write(name, text));
    return refusal_of(*daemon);
  };
  const std::string whole = text_of(good);
  const auto next_line = std::ranges::count(whole, '\n') + 1;
  const auto at = [&](const std::string& name, std::ptrdiff_t line) {
    return bench.folder().string() + "/" + name + ":" + std::to_string(line) + ":";
  };

  CHECK_THAT(refused("key.yaml", whole + "lnik: {}\n"),
             ContainsSubstring(at("key.yaml", next_line) + "1: unknown key"));
  CHECK_THAT(refused("twice.yaml", whole + "run: {}\n"),
             ContainsSubstring(at("twice.yaml", next_line) + "1:"));
  CHECK_THAT(refused("syntax.yaml", whole + "robot: {\n"),
             ContainsSubstring(at("syntax.yaml", next_line + 1)));
  CHECK_THAT(refused("unit.yaml", whole + "robot:\n  wheel_base_m: 235\n"),
             ContainsSubstring(at("unit.yaml", next_line + 1)));

  bench.write("route.yaml", "name: test\nspeed: fast\n");
  const auto bad_route = bench.start_daemon(good);
  CHECK_THAT(refusal_of(*bad_route), ContainsSubstring(bench.folder().string() + "/route.yaml:2:"));
  CHECK(tap.sent_by_daemon() == 0);
}

TEST_CASE("A model that is missing, broken or for another period is refused before anything moves") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto config = bench.configure({.device = "tapped"});
  const auto refused = [&] {
    const auto daemon = bench.start_daemon(config);
    return refusal_of(*daemon);
  };
  const std::string whole = text_of(bench.folder() / "model.yaml");

  std::string slower = whole;
  slower.replace(slower.find("0.018"), 5, "0.020");
  bench.write("model.yaml", slower);
  CHECK_THAT(refused(), ContainsSubstring("another period"));
  bench.write("model.yaml", whole.substr(0, whole.size() / 2));
  CHECK_THAT(refused(), ContainsSubstring("model.yaml:"));
  std::filesystem::remove(bench.folder() / "model.yaml");
  CHECK_THAT(refused(), ContainsSubstring("no such model"));
  CHECK(tap.sent_by_daemon() == 0);
}

TEST_CASE("A log folder that cannot be made is named before anything moves") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto config = bench.configure({.device = "tapped"});
  bench.write("runs", "a file in the way\n");
  const auto daemon = bench.start_daemon(config);
  CHECK_THAT(refusal_of(*daemon), ContainsSubstring(bench.folder().string() + "/runs"));
  CHECK(tap.sent_by_daemon() == 0);
}
