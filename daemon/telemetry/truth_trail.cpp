#include "daemon/telemetry/truth_trail.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace wheelwright::daemon::telemetry {
namespace {

// While no start is known, so much of the past is kept: the start may lie in it.
constexpr std::size_t max_unread = 2000;
constexpr std::streamoff longest_line = 64 * 1024;  // what is longer is none of the truth, and is left out
constexpr std::string_view start_key = "# started_unix_ms: ";

// The first four numbers of a line: t, x, y, theta.
bool read_numbers(std::string_view line, std::array<double, 4>& numbers) {
  for (double& number : numbers) {
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (line.starts_with(',')) line.remove_prefix(1);
  }
  return true;
}

}  // namespace

void TruthTrail::start_at(std::uint64_t time_ns) {
  start_ns_ = time_ns;
  origin_.reset();
}

std::vector<TimedPose> TruthTrail::read() {
  read_lines();
  std::vector<TimedPose> poses;
  if (!start_ns_) return poses;
  for (const TimedPose& sample : unread_) {
    if (sample.time_ns < *start_ns_) continue;
    if (!origin_) origin_ = sample.pose;
    poses.push_back({sample.time_ns, between(*origin_, sample.pose)});
  }
  unread_.clear();
  return poses;
}

// Whole lines only: the last one may still be on its way. A file that has become shorter is another one.
void TruthTrail::read_lines() {
  std::error_code missing;
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(file_, missing));
  if (missing || size < position_) {
    in_.close();
    position_ = 0;
    file_started_ns_.reset();
    if (missing) return;
  }
  if (size == position_) return;
  if (!in_.is_open()) in_.open(file_);
  in_.clear();
  in_.seekg(position_);
  std::string block;
  while (position_ < size) {
    block.resize(static_cast<std::size_t>(std::min(size - position_, longest_line)));
    in_.read(block.data(), static_cast<std::streamsize>(block.size()));
    block.resize(static_cast<std::size_t>(in_.gcount()));
    const auto lines_end = block.rfind('\n');
    if (lines_end != std::string::npos) {
      take_lines(std::string_view(block).substr(0, lines_end + 1));
      block.resize(lines_end + 1);
    } else if (static_cast<std::streamoff>(block.size()) < longest_line) {
      return;  // it is still on its way, or cannot be read now
    }
    position_ += static_cast<std::streamoff>(block.size());
    in_.clear();
    in_.seekg(position_);
  }
}

void TruthTrail::take_lines(std::string_view lines) {
  while (!lines.empty()) {
    const auto end = lines.find('\n');
    take_line(lines.substr(0, end));
    lines.remove_prefix(end + 1);
  }
}

void TruthTrail::take_line(std::string_view line) {
  if (line.starts_with(start_key)) {
    std::uint64_t unix_ms = 0;
    std::from_chars(line.data() + start_key.size(), line.data() + line.size(), unix_ms);
    file_started_ns_ = unix_ms * 1'000'000U;
  }
  std::array<double, 4> numbers{};
  if (!file_started_ns_ || line.starts_with('#') || !read_numbers(line, numbers)) return;
  const auto since_start_ns = static_cast<std::uint64_t>(std::llround(1e9 * numbers[0]));
  unread_.push_back({*file_started_ns_ + since_start_ns, {numbers[1], numbers[2], numbers[3]}});
  if (unread_.size() > max_unread) unread_.pop_front();
}

}  // namespace wheelwright::daemon::telemetry
