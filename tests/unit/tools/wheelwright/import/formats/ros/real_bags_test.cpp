// Bags of real robots, against extracts that others made of them.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "config/load/text_file.hpp"
#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/open_recording.hpp"

using namespace wheelwright;
namespace fs = std::filesystem;
using import::Recording;
using import::Stream;

namespace {

// Nothing, and a visible word of it, on a machine without them.
std::optional<fs::path> data_folder(const std::string& part) {
  const char* given = std::getenv("WHEELWRIGHT_DATA");
  const fs::path data =
      given != nullptr ? fs::path(given) : fs::path(WHEELWRIGHT_SOURCE_DIR).parent_path() / "shared" / "data";
  if (fs::exists(data / part)) return data / part;
  WARN("SKIPPED: no recordings at " << (data / part));
  SUCCEED("SKIPPED");
  return std::nullopt;
}

Recording read(const fs::path& path) {
  auto recording = import::open_recording(path);
  INFO((recording ? "" : recording.error()));
  REQUIRE(recording.has_value());
  return *std::move(recording);
}

void check_near(const std::vector<double>& found, const std::vector<double>& right, double tolerance) {
  REQUIRE(found.size() == right.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) largest = std::max(largest, std::abs(found[i] - right[i]));
  CHECK(largest <= tolerance);
}

// Columns of a CSV file, one row a line.
std::vector<double> column(const fs::path& path, const std::string& name) {
  const auto text = config::read_text(path, config::log_file);
  REQUIRE(text.has_value());
  std::vector<double> values;
  std::size_t at = 0;
  std::size_t line_start = 0;
  for (bool is_header = true; line_start < text->size(); is_header = false) {
    const std::size_t line_end = std::min(text->find('\n', line_start), text->size());
    std::vector<std::string> fields{""};
    for (const char c : text->substr(line_start, line_end - line_start)) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    if (is_header) {
      at = static_cast<std::size_t>(std::ranges::find(fields, name) - fields.begin());
    } else {
      values.push_back(std::strtod(fields.at(at).c_str(), nullptr));
    }
    line_start = line_end + 1;
  }
  return values;
}

}  // namespace

TEST_CASE("The bag of a TurtleBot has the numbers that others found in it") {
  const auto folder = data_folder("robots/turtlebot3-rob521");
  if (!folder) return;
  const Recording recording = read(*folder / "sample_data.bag");
  const Stream* commands = recording.find("/cmd_vel");
  const Stream* sensors = recording.find("/sensor_state");
  REQUIRE((commands != nullptr && sensors != nullptr));
  const fs::path cmd_vel = *folder / "sample_data_cmd_vel.csv";
  const fs::path sensor_state = *folder / "sample_data_sensor_state.csv";
  check_near(commands->received_s, column(cmd_vel, "bag_time_s"), 1e-6);
  check_near(commands->find("linear.x")->values, column(cmd_vel, "linear_x_m_s"), 1e-4);
  check_near(commands->find("angular.z")->values, column(cmd_vel, "angular_z_rad_s"), 1e-4);
  check_near(sensors->find("header.stamp")->values, column(sensor_state, "header_stamp_s"), 1e-6);
  check_near(sensors->find("left_encoder")->values, column(sensor_state, "left_encoder"), 0);
  check_near(sensors->find("right_encoder")->values, column(sensor_state, "right_encoder"), 0);
  check_near(sensors->find("battery")->values, column(sensor_state, "battery_v"), 1e-3);
}

TEST_CASE("The poses of a bag of ROS 1 are those of the same bag in ROS 2") {
  const auto folder = data_folder("bags/evo");
  if (!folder) return;
  const Recording ros1 = read(*folder / "tf_example.bag");
  const Recording ros2 = read(*folder / "tf_example");
  const Stream* first = ros1.find("/tf:odom.base_footprint");
  const Stream* second = ros2.find("/tf:odom.base_footprint");
  REQUIRE((first != nullptr && second != nullptr));
  CHECK(first->rows == 517);
  check_near(first->received_s, second->received_s, 0);
  for (const auto& channel : second->channels)
    check_near(first->find(channel.name)->values, channel.values, 0);
}

TEST_CASE("Odometry, localisation and transforms of a TurtleBot are found in its MCAP file") {
  const auto folder = data_folder("bags/evo");
  if (!folder) return;
  const Recording recording = read(*folder / "nav2_turtlebot.mcap");
  CHECK(recording.format == "ROS 2 bag (MCAP, zstd)");
  CHECK(recording.find("/odom")->rows == 2639);
  CHECK(recording.find("/amcl_pose")->rows == 135);
  CHECK(recording.find("/tf:map.odom")->rows == 921);
  // What the robot says of its place in two ways is the same.
  check_near(recording.find("/odom")->find("pose.pose.position.x")->values,
             recording.find("/tf:odom.base_link")->find("transform.translation.x")->values, 1e-12);
}

TEST_CASE("The messages of split bags are as many as their metadata.yaml says") {
  const auto folder = data_folder("bags");
  if (!folder) return;
  for (const char* bag : {"split_mcap/wbag", "split_sqlite3/wbag"}) {
    const Recording recording = read(*folder / bag);
    CHECK(recording.streams.size() == 8);
    std::size_t rows = 0;
    for (const Stream& stream : recording.streams) rows += stream.rows;
    CHECK(rows == 6074);
    CHECK(recording.find("HHH")->rows == 726);
  }
  CHECK(read(*folder / "talker_mcap").find("/topic")->rows == 10);
}
