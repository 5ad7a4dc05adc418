#include "config/load/rest_target.hpp"

#include <fstream>

#include "daemon/guardian/rest.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::salvage_rest_target;

namespace {

std::filesystem::path file_with(const std::string& text) {
  const auto file = test::temporary_folder() / "rest_target.yaml";
  std::ofstream(file) << text;
  return file;
}

}  // namespace

TEST_CASE("The way to the robot is read from a configuration with mistakes in other places") {
  for (const std::string mistake :
       {"lnik: {}\n", "run: {route: gone.yaml, speed: -1}\n", "limits: 7\n", "run: {route: [\n", "\tx: 1\n",
        "a: b: c\n", "]\n", "run: \"no end\n", "{}{}\n"}) {
    CAPTURE(mistake);
    const auto target =
        salvage_rest_target(file_with("link: {device: /dev/ttyUSB7, baud: 19200, drive: pwm}\n" + mistake));
    REQUIRE(target);
    CHECK(target->device == "/dev/ttyUSB7");
    CHECK(target->baud == 19200);
    CHECK(target->drive_mode == roomba::DriveMode::pwm);
  }
}

TEST_CASE("A wrong baud rate or drive is no reason not to reach the robot") {
  const auto target =
      salvage_rest_target(file_with("link:\n  device: /dev/ttyUSB7\n  baud: fast\n  drive: [1]\n"));
  REQUIRE(target);
  CHECK(target->device == "/dev/ttyUSB7");
  CHECK(target->baud == 115200);
  CHECK(target->drive_mode == roomba::DriveMode::direct);
}

TEST_CASE("A file that names no device says nothing about the robot") {
  for (const std::string text :
       {"", "run: {}\n", "link: {baud: 19200}\n", "link: 5\n", "[\n", "\xff\xfe", "- a\n- b\n"}) {
    CAPTURE(text);
    CHECK_FALSE(salvage_rest_target(file_with(text)));
  }
  CHECK_FALSE(salvage_rest_target("/no/such/file.yaml"));
  CHECK_FALSE(salvage_rest_target("/"));
}

TEST_CASE("The way to the robot that a daemon keeps is read as it was written") {
  const config::RestTarget kept{"/dev/serial/by-id/usb \"quoted\" #1", 19200, roomba::DriveMode::pwm};
  const auto read = salvage_rest_target(file_with(config::rest_target_to_yaml(kept)));
  REQUIRE(read);
  CHECK(read->device == kept.device);
  CHECK(read->baud == kept.baud);
  CHECK(read->drive_mode == kept.drive_mode);
}

TEST_CASE("The robot is looked for where it was driven, then as configured, then at the usual place") {
  const auto folder = test::temporary_folder() / "runtime";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / daemon::rest_target_file_name)
      << config::rest_target_to_yaml({"/dev/ttyUSB1", 19200, roomba::DriveMode::direct});
  const auto config = file_with("link: {device: /dev/ttyUSB2}\n");
  const auto devices = [](const std::vector<config::RestTarget>& targets) {
    std::vector<std::string> names;
    for (const auto& target : targets)
      names.push_back(target.device.string() + "@" + std::to_string(target.baud));
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(devices(daemon::rest_targets(folder, config, "")) ==
        Names{"/dev/ttyUSB1@19200", "/dev/ttyUSB2@115200", "/dev/roomba@115200"});
  CHECK(devices(daemon::rest_targets("", config, "")) == Names{"/dev/ttyUSB2@115200", "/dev/roomba@115200"});
  CHECK(devices(daemon::rest_targets("", "/no/such/file.yaml", "")) == Names{"/dev/roomba@115200"});
  CHECK(devices(daemon::rest_targets(folder, config, "/dev/ttyS0")) ==
        Names{"/dev/ttyS0@19200", "/dev/ttyS0@115200"});
}
