#include <filesystem>
#include <fstream>

#include "config/load/yaml_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;
using wheelwright::config::ConfigError;
using wheelwright::config::load_room;
using wheelwright::config::load_simulation_config;

namespace {

const std::filesystem::path robots = std::filesystem::path(WHEELWRIGHT_SOURCE_DIR) / "config/robots";

std::filesystem::path file_with(const std::string& text) {
  const auto path = wheelwright::test::temporary_folder() / "wheelwright_robot_test.yaml";
  std::ofstream(path) << text;
  return path;
}

std::string error_of(const std::string& text) {
  try {
    load_simulation_config(file_with(text));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("Every robot and every room that ships can be loaded") {
  for (const auto& entry : std::filesystem::directory_iterator(robots)) {
    if (entry.path().extension() == ".yaml") CHECK_NOTHROW(load_simulation_config(entry.path()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(robots / "rooms")) {
    CHECK_NOTHROW(load_room(entry.path()));
  }
}

TEST_CASE("A robot based on another one keeps what it does not change, and what both wheels share") {
  const auto base = load_simulation_config(robots / "default.yaml");
  const auto worn = load_simulation_config(robots / "old_motors.yaml");
  CHECK(worn.name == "old_motors");
  CHECK(worn.left.friction.stiction_nm == 0.24);
  CHECK(worn.right.friction.stiction_nm == 0.24);
  CHECK(worn.left.motor.resistance_ohm == base.left.motor.resistance_ohm);
  CHECK(worn.firmware.proportional_v_s_per_m == base.firmware.proportional_v_s_per_m);
  CHECK(worn.room.obstacles.size() == base.room.obstacles.size());
}

TEST_CASE("An unknown key, a value out of range and an odd baud rate are refused with their place") {
  CHECK_THAT(error_of("wheels: { diametre_m: 0.07 }\n"), ContainsSubstring("did you mean 'diameter_m'?"));
  CHECK_THAT(error_of("seed: 1\nchassis: { mass_kg: 0 }\n"), ContainsSubstring(".yaml:2:"));
  CHECK_THAT(error_of("link: { baud: 115000 }\n"), ContainsSubstring("no speed of the Open Interface"));
}

TEST_CASE("A robot that is based on itself is refused") {
  CHECK_THAT(error_of("based_on: wheelwright_robot_test.yaml\n"), ContainsSubstring("circle"));
}
