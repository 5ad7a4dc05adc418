// Logs that no daemon wrote are refused, with the row, before they reach the brain.
#include "daemon/replay/recorded_frames.hpp"

#include <algorithm>
#include <string>

#include "config/load/daemon_config.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/yaml_reader.hpp"
#include "daemon/recording/log_format.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// Five ticks of a robot that stands, as the daemon logs them.
DriveLog log_of_daemon() {
  std::string text = daemon::drive_log_head({}, {0.0004, 0.0004});
  for (int tick = 0; tick < 5; ++tick) {
    daemon::LogEntry entry;
    entry.frame.valid = true;
    entry.frame.command.activity = Activity::route;
    entry.record.tick = tick;
    entry.record.t_s = 0.018 * tick;
    text += daemon::drive_log_line(entry) + "\n";
  }
  return config::parse_drive_logs(text, "run.csv").front();
}

ExtraColumn& column(DriveLog& log, const std::string& name) {
  return *std::find_if(log.extra_columns.begin(), log.extra_columns.end(),
                       [&](const ExtraColumn& candidate) { return candidate.name == name; });
}

std::string refusal(const DriveLog& log) {
  try {
    const daemon::RecordedFrames frames(log);
    for (std::size_t row = 0; row < frames.size(); ++row) {
      frames.frame_with_command(row);
      frames.model_version(row);
    }
  } catch (const config::ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A log of the daemon is taken") {
  CHECK(refusal(log_of_daemon()).empty());
}

TEST_CASE("A log in whose columns stands what no daemon writes is refused with its row") {
  for (const std::string name : {"overcurrents", "light_left", "travel_ticks_right", "current_left_a", "tick",
                                 "model_version", "repetition", "late_us"}) {
    for (const double value : {std::nan(""), 1e308, -1e308}) {
      DriveLog log = log_of_daemon();
      column(log, name).values.at(2) = value;
      CHECK_THAT(refusal(log), ContainsSubstring("'" + name + "' must be a number from"));
    }
  }
}

TEST_CASE("A log whose ticks fall, or whose words are numbers, is refused") {
  DriveLog falls = log_of_daemon();
  column(falls, "tick").values.at(3) = 1.0;
  CHECK_THAT(refusal(falls), ContainsSubstring("'tick' must rise"));
  DriveLog numbers = log_of_daemon();
  column(numbers, "activity").texts.clear();
  CHECK_THAT(refusal(numbers), ContainsSubstring("'activity' must hold words"));
}
