// Rows that are numbered by the frames of a camera or the samples of a recorder.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> frame_base{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

std::string frames(const std::string& above, const std::string& name, std::size_t lost = 0) {
  const ForeignDrive drive = foreign_drive();
  std::string text = above + name + ",cmd_left,cmd_right,enc_left,enc_right\n";
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    if (k == lost && lost > 0) continue;
    const ForeignRow& row = drive.rows[k];
    text += std::to_string(100 + k) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
            counts(row) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("The number of a frame and the rate that a file states are the time") {
  for (const auto& [above, name] :
       std::vector<std::pair<std::string, std::string>>{{"# fps: 20\n", "frame"},
                                                        {"# Frame Rate (Hz): 20\n", "Frame"},
                                                        {"FPS=20\n", "frame_no"},
                                                        {"# sample_rate: 20 Hz\n", "sample"}}) {
    INFO(above << name);
    check_same(import_text(frames(above, name), frame_base), foreign_drive());
  }
}

TEST_CASE("A rate may be given, and frames that are lost leave a gap") {
  auto settings = frame_base;
  settings.emplace_back("time.rate_hz=20");
  const auto outcome = import_text(frames("", "frame", 700), settings);
  REQUIRE(outcome.conversion);
  const auto& samples = outcome.conversion->runs.front().samples;
  CHECK_THAT(samples[700].t_s - samples[699].t_s, WithinAbs(0.1, 1e-9));
  CHECK_THAT(samples.back().t_s, WithinAbs(1199 * 0.05, 1e-6));
}

TEST_CASE("Frames without a rate are no time, and the key to give it is said") {
  const auto outcome = import_text(frames("", "frame"), frame_base);
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("--set time.rate_hz=30"));
}

TEST_CASE("Frames of a reference in a file of its own are as far apart as the rate that is given") {
  const ForeignDrive drive = foreign_drive();
  const std::string robot =
      foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right", [](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  std::string camera = "frame,x,y,theta\n";
  for (std::size_t k = 0; k < drive.rows.size(); k += k == 700 ? 5 : 1) {
    const ForeignRow& row = drive.rows[k];
    camera +=
        std::to_string(k + 60) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta) + "\n";
  }
  const auto without_rate = import::understand(
      {{file_of("robot.csv", robot)}, file_of("camera.csv", camera), import::GivenMapping("", frame_base)});
  REQUIRE_FALSE(without_rate);
  CHECK_THAT(without_rate.error(), ContainsSubstring("--set time.rate_hz=100"));
  auto settings = frame_base;
  settings.emplace_back("time.rate_hz=20");
  const auto understood = import::understand(
      {{file_of("robot.csv", robot)}, file_of("camera.csv", camera), import::GivenMapping("", settings)});
  REQUIRE(understood);
  CHECK_THAT(*understood->mapping.reference->shift_s, WithinAbs(-3.0, 0.02));
  const auto conversion = import::to_runs(*understood);
  REQUIRE(conversion);
  CHECK_THAT(*conversion->runs.front().samples[900].reference_x_m, WithinAbs(drive.rows[900].x, 0.005));
}
