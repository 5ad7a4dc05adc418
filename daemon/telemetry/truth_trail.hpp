// Where the robot truly is, for who watches a simulated one: the file that `roomba-sim --truth` writes, read
// while it grows. The daemon drives by none of it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/geometry/pose.hpp"

namespace wheelwright::daemon::telemetry {

struct TimedPose {
  std::uint64_t time_ns = 0;  // Unix time
  Pose pose;
};

class TruthTrail {
 public:
  // The file need not be there yet.
  explicit TruthTrail(std::filesystem::path file) : file_(std::move(file)) {}

  // From now on poses are seen from where the robot is at this time, as the daemon's own poses are when they
  // are zero.
  void start_at(std::uint64_t time_ns);

  // What the file has got since the last call, from the start on, seen from there. Nothing where the file is
  // not there, or is no truth file.
  std::vector<TimedPose> read();

 private:
  void read_lines();
  void take_lines(std::string_view lines);
  void take_line(std::string_view line);

  std::filesystem::path file_;
  std::ifstream in_;
  std::streamoff position_ = 0;
  std::optional<std::uint64_t> file_started_ns_;
  std::deque<TimedPose> unread_;  // in the robot's room
  std::optional<std::uint64_t> start_ns_;
  std::optional<Pose> origin_;
};

}  // namespace wheelwright::daemon::telemetry
