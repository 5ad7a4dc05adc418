#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"

#include <fstream>

#include "config/load/yaml_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using namespace wheelwright::import;

namespace {

std::string file_with(const std::string& text) {
  const auto path = test::temporary_folder() / "wheelwright_mapping_test.yaml";
  std::ofstream(path) << text;
  return path.string();
}

}  // namespace

TEST_CASE("A mapping survives its own text") {
  Mapping mapping;
  mapping.time.column = ChannelName{"", "data(:,1)"};
  mapping.time.unit = TimeUnit::ms;
  mapping.command = CommandMapping{.kind = CommandKind::twist,
                                   .first = {"/cmd_vel", "linear.x"},
                                   .second = ChannelName{"/cmd_vel", "angular.z"},
                                   .unit = "mm/s",
                                   .angular_unit = "deg/s"};
  mapping.wheels = WheelMapping{.left = {"/sensor_state", "left_encoder"},
                                .right = ChannelName{"/sensor_state", "right_encoder"},
                                .bits = 16,
                                .counts_per_turn = 4096,
                                .wheel_radius_m = 0.033,
                                .right_reversed = true};
  mapping.robot = "a robot: with a colon";
  mapping.wheel_base_m = 0.287;
  const auto entries = mapping_entries(mapping);
  const auto again = mapping_entries(to_mapping(entries, "test"));
  REQUIRE(again.size() == entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    CHECK(again[i].key == entries[i].key);
    CHECK(again[i].value == entries[i].value);
  }
}

TEST_CASE("Single keys hold against the mapping file") {
  const auto file = file_with("wheelwright_mapping: 1\nrobot: {wheel_base_m: 0.3}\ntime: {unit: ms}\n");
  const GivenMapping given(file, {"robot.wheel_base_m=0.25"});
  REQUIRE(given.says("robot.wheel_base_m"));
  CHECK(*given.find("robot.wheel_base_m") == "0.25");
  CHECK(*given.find("time.unit") == "ms");
  CHECK_FALSE(given.says("command.left"));
}

TEST_CASE("A mapping that cannot be meant is refused with its place and what would be right") {
  CHECK_THROWS_WITH(GivenMapping("", {"robot.weel_base_m=0.25"}), ContainsSubstring("robot.wheel_base_m"));
  CHECK_THROWS_WITH(GivenMapping("", {"robot.wheel_base_m"}), ContainsSubstring("KEY=VALUE"));
  CHECK_THROWS_WITH(GivenMapping("", {"robot.wheel_base_m=wide"}), ContainsSubstring("number"));
  CHECK_THROWS_WITH(GivenMapping("", {"command.unit=parsec"}), ContainsSubstring("must be one of m/s"));
  CHECK_THROWS_AS(GivenMapping(file_with("wheelwright_mapping: 1\nwheel: {left: a}\n"), {}),
                  config::ConfigError);
  CHECK_THROWS_AS(GivenMapping(file_with("robot: {wheel_base_m: 0.3}\n"), {}), config::ConfigError);
}

TEST_CASE("What contradicts itself names the option that said it, never a text that nobody wrote") {
  const auto refused = [](const std::vector<std::string>& settings) {
    try {
      to_mapping(GivenMapping("", settings).entries(), "drive.csv");
    } catch (const config::ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(refused({"command.left=a", "command.linear=b"}),
             Catch::Matchers::Equals(
                 "--set command.left=a: command.left does not go with the other keys of its section; leave "
                 "it out, or them"));
  CHECK_THAT(refused({"wheels.kind=angle", "wheels.unit=m/s"}),
             Catch::Matchers::StartsWith("--set wheels.unit=m/s: 'unit'"));
  CHECK_THAT(refused({"wheels.unit=furlong"}),
             Catch::Matchers::StartsWith("--set wheels.unit=furlong: 'unit' 'furlong'"));
  const auto file = file_with("wheelwright_mapping: 1\nwheels: {left: a, unit: m/s}\n");
  try {
    to_mapping(GivenMapping(file, {"wheels.kind=angle"}).entries(), "drive.csv");
    FAIL("was not refused");
  } catch (const config::ConfigError& error) {
    CHECK_THAT(error.what(), Catch::Matchers::StartsWith(file + ": wheels.unit: 'unit'"));
  }
  try {
    to_mapping({{"wheels.left", "a"}, {"wheels.kind", "angle"}, {"wheels.unit", "m/s"}}, "drive.csv");
    FAIL("was not refused");
  } catch (const config::ConfigError& error) {
    CHECK_THAT(error.what(), Catch::Matchers::StartsWith("drive.csv: wheels.unit 'm/s': 'unit'"));
  }
}
