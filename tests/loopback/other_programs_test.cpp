// What roomba-sim and serial-faults refuse, and say.
#include <algorithm>
#include <csignal>

#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// What a program says that is to refuse what it was told.
std::string refusal_of(const Bench& bench, const std::vector<std::string>& command) {
  ChildProcess program(command, bench.folder() / "refused_said");
  CHECK(program.wait(5s) == 2);
  CHECK(program.out().empty());
  const std::string said = program.err();
  CAPTURE(said);
  CHECK(std::count(said.begin(), said.end(), '\n') == 1);
  return said;
}

}  // namespace

TEST_CASE(
    "A second simulated robot leaves the link of the first alone, and follows it once that was killed") {
  Bench bench;
  const auto first = bench.start_robot("perfect");
  const auto target = std::filesystem::read_symlink(bench.device());
  const std::vector<std::string> second{ROOMBA_SIM, "--link", bench.device().string()};
  const std::string said = refusal_of(bench, second);
  CHECK_THAT(said,
             ContainsSubstring("leads to " + target.string()) && ContainsSubstring("(roomba-sim) holds"));
  CHECK(std::filesystem::read_symlink(bench.device()) == target);

  first->signal(SIGKILL);
  REQUIRE(first->wait(5s) != ChildProcess::still_running);
  REQUIRE(std::filesystem::is_symlink(bench.device()));
  ChildProcess other(second, bench.folder() / "second_said");
  CHECK(eventually(5s, [&] { return std::filesystem::exists(bench.device()); }));
  CHECK(other.wait(0ms) == ChildProcess::still_running);
}

TEST_CASE("serial-faults refuses pauses and numbers that are none, and says which would do") {
  const Bench bench;
  const std::string link = (bench.folder() / "faulty").string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--shortest-pause", "5", "--longest-pause", "3"}, "--shortest-pause is longer than --longest-pause"},
      {{"--shortest-pause", "-1"}, "--shortest-pause: is '-1', but must be a number from 0.001 to 86400 s"},
      {{"--longest-pause", "nan"}, "--longest-pause: is 'nan', but must be a number"},
      {{"--first", "-0.5"}, "--first: is '-0.5', but must be a number from 0 to 86400 s"},
      {{"--first", "inf"}, "--first: is 'inf', but must be a number"},
      {{"--faults", "-3"}, "--faults"},
      {{"--kinds", "drop,melt"}, "no fault is called 'melt'; there are delay"},
  };
  for (const auto& [options, expected] : wrong) {
    std::vector<std::string> command{SERIAL_FAULTS, "--robot", bench.device().string(), "--link", link};
    command.insert(command.end(), options.begin(), options.end());
    CHECK_THAT(refusal_of(bench, command), ContainsSubstring(expected));
  }
}

TEST_CASE("Every program tells its version") {
  const Bench bench;
  for (const std::string program : {WHEELWRIGHT, WHEELWRIGHTD, ROOMBA_SIM, SERIAL_FAULTS}) {
    ChildProcess asked({program, "--version"}, bench.folder() / "version_said");
    CHECK(asked.wait(5s) == 0);
    const std::string name = std::filesystem::path(program).filename().string();
    CHECK(asked.out().starts_with(name + " 0."));
  }
}
