#include "daemon/service/restarts.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using wheelwright::daemon::Restarts;
using wheelwright::daemon::ServiceFolders;

namespace {

ServiceFolders empty_folders() {
  const auto folder = wheelwright::test::temporary_folder() / "restarts";
  std::filesystem::remove_all(folder);
  const ServiceFolders folders{folder / "runtime", folder / "state"};
  std::filesystem::create_directories(folders.runtime);
  std::filesystem::create_directories(folders.state);
  return folders;
}

void lose(const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
}

}  // namespace

TEST_CASE(
    "A service that keeps ending out of order waits 1 s, then twice as long each time, up to a minute") {
  const auto folders = empty_folders();
  std::vector<std::int64_t> waits;
  for (int i = 0; i < 11; ++i) waits.push_back(Restarts(folders).back_off().count());
  CHECK(waits == std::vector<std::int64_t>{0, 0, 1, 2, 4, 8, 16, 32, 60, 60, 60});
}

TEST_CASE("An end in order, or a process that lasted, ends the row of failures") {
  const auto folders = empty_folders();
  for (int i = 0; i < 5; ++i) const Restarts failing(folders);
  Restarts lasting(folders);
  CHECK(lasting.back_off() > std::chrono::seconds(0));
  lasting.lasted();
  CHECK(Restarts(folders).back_off() == std::chrono::seconds(0));
  for (int i = 0; i < 5; ++i) const Restarts failing(folders);
  Restarts(folders).ended_in_order();
  CHECK(Restarts(folders).back_off() == std::chrono::seconds(0));
  for (int i = 0; i < 5; ++i) const Restarts failing(folders);
  Restarts(folders).ended_in_drive();
  CHECK(Restarts(folders).back_off() == std::chrono::seconds(0));
}

TEST_CASE("A process knows that the one before it ended while the robot was armed, after a power cut too") {
  const auto folders = empty_folders();
  CHECK_FALSE(Restarts(folders).hold());
  CHECK_FALSE(Restarts(folders).armed());
  lose(folders.runtime);
  REQUIRE(Restarts(folders).hold());
  CHECK(*Restarts(folders).hold() == "the process before this one ended while the robot was armed");
  Restarts(folders).ended_in_drive();
  CHECK(Restarts(folders).hold());
  Restarts(folders).ended_in_order();
  CHECK_FALSE(Restarts(folders).hold());
}

TEST_CASE("A robot is not to be armed where the note of it cannot be kept") {
  auto folders = empty_folders();
  std::filesystem::remove_all(folders.state);
  const auto error = Restarts(folders).armed();
  REQUIRE(error);
  CHECK_THAT(*error, ContainsSubstring((folders.state / "hold").string()));
  folders.state.clear();
  const auto unset = Restarts(folders).armed();
  REQUIRE(unset);
  CHECK_THAT(*unset, ContainsSubstring("StateDirectory="));
}

TEST_CASE("The reason of a note that another program wrote is kept, and holds whatever it is") {
  const auto folders = empty_folders();
  std::ofstream(folders.state / "hold") << "the package was upgraded\nmore\n";
  CHECK(Restarts(folders).hold() == "the package was upgraded");
  for (const std::string text : {"", "\n", "\x1b[2J", "\xff"}) {
    std::ofstream(folders.state / "hold") << text;
    CHECK(Restarts(folders).hold() == "the process before this one ended while the robot was armed");
  }
  std::filesystem::remove(folders.state / "hold");
  std::filesystem::create_directory(folders.state / "hold");
  CHECK(Restarts(folders).hold());
}

TEST_CASE("By hand nothing is remembered, and nothing stands in the way of arming") {
  CHECK_FALSE(Restarts(std::nullopt).armed());
  CHECK_FALSE(Restarts(std::nullopt).hold());
  CHECK(Restarts(std::nullopt).back_off() == std::chrono::seconds(0));
}
