#include "daemon/restarts.hpp"

#include <chrono>
#include <filesystem>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using wheelwright::daemon::Restarts;

namespace {

std::filesystem::path empty_folder() {
  const auto folder = wheelwright::test::temporary_folder() / "restarts";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  return folder;
}

}  // namespace

TEST_CASE(
    "A service that keeps ending out of order waits 1 s, then twice as long each time, up to a minute") {
  const auto folder = empty_folder();
  std::vector<std::int64_t> waits;
  for (int i = 0; i < 11; ++i) waits.push_back(Restarts(folder).back_off().count());
  CHECK(waits == std::vector<std::int64_t>{0, 0, 1, 2, 4, 8, 16, 32, 60, 60, 60});
}

TEST_CASE("An end in order, or a process that lasted, ends the row of failures") {
  const auto folder = empty_folder();
  for (int i = 0; i < 5; ++i) Restarts(folder).armed();
  Restarts lasting(folder);
  CHECK(lasting.back_off() > std::chrono::seconds(0));
  lasting.lasted();
  CHECK(Restarts(folder).back_off() == std::chrono::seconds(0));
  for (int i = 0; i < 5; ++i) Restarts(folder).armed();
  Restarts(folder).ended_in_order();
  CHECK(Restarts(folder).back_off() == std::chrono::seconds(0));
}

TEST_CASE("A process knows that the one before it was killed while the robot was armed") {
  const auto folder = empty_folder();
  CHECK_FALSE(Restarts(folder).was_armed());
  Restarts(folder).armed();
  CHECK(Restarts(folder).was_armed());
  Restarts(folder).ended_in_order();
  CHECK_FALSE(Restarts(folder).was_armed());
}

TEST_CASE("Without a runtime folder nothing is remembered") {
  Restarts("").armed();
  CHECK_FALSE(Restarts("").was_armed());
  CHECK(Restarts("").back_off() == std::chrono::seconds(0));
}
