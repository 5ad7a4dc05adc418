// A program beside the daemon that takes only what the others leave.
#include "daemon/model_watch/idle_process.hpp"

#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright::daemon;
using namespace std::chrono_literals;

namespace {

struct Ended {
  int status = -1;
  std::string said;
};

Ended run(const std::string& program, const std::vector<std::string>& arguments,
          const IdleProcessLimits& limits = {}) {
  const auto said = wheelwright::test::temporary_folder() / "said.txt";
  IdleProcess process(program, arguments, said, limits);
  std::optional<int> status;
  while (!(status = process.ended())) std::this_thread::sleep_for(5ms);
  std::ostringstream text;
  text << std::ifstream(said).rdbuf();
  return {*status, text.str()};
}

}  // namespace

TEST_CASE("What an idle process says on either output is kept, and its status is known") {
  const Ended ended = run("/bin/sh", {"-c", "echo one; echo two >&2; exit 3"});
  CHECK(ended.status == 3);
  CHECK(ended.said == "one\ntwo\n");
}

TEST_CASE("An idle process runs at the lowest priority and within its memory") {
  const Ended ended =
      run("/bin/sh", {"-c", "until [ \"$(ulimit -d)\" != unlimited ]; do :; done; nice; ulimit -d"});
  CHECK(ended.said == "19\n" + std::to_string((100U << 20U) / 1024) + "\n");
}

TEST_CASE("A program that is not there ends with 127") {
  CHECK(run("/nowhere/program", {}).status == 127);
}

TEST_CASE("An idle process that takes too long is ended") {
  IdleProcessLimits limits;
  limits.time = 0s;
  CHECK(run("/bin/sleep", {"60"}, limits).status == 128 + 9);
}

TEST_CASE("An idle process ends with who started it") {
  const auto said = wheelwright::test::temporary_folder() / "pid.txt";
  int pid = 0;
  {
    IdleProcess process("/bin/sh", {"-c", "echo $$; exec sleep 600"}, said);
    while (!(std::ifstream(said) >> pid)) std::this_thread::sleep_for(5ms);
    CHECK(::kill(pid, 0) == 0);
  }
  CHECK(::kill(pid, 0) != 0);
}
