#include "tools/wheelwright/common/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "config/load/printable_text.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::size_t bar_width = 20;
constexpr double min_share_to_judge = 0.05;
constexpr double min_time_to_judge_s = 1.0;
constexpr double long_s = 2.0;  // from then on it is said how long the work at hand has taken

bool is_terminal(const std::ostream& stream) {
  const char* kind = std::getenv("TERM");
  return &stream == &std::cerr && ::isatty(STDERR_FILENO) == 1 &&
         (kind == nullptr || std::string_view(kind) != "dumb");
}

std::string time_text(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 120 ? std::to_string(whole) + " s" : std::to_string((whole + 30) / 60) + " min";
}

}  // namespace

std::string progress_text(const std::string& what, double share, double passed_s) {
  share = std::clamp(share, 0.0, 1.0);
  const auto done = static_cast<std::size_t>(std::lround(share * static_cast<double>(bar_width)));
  const std::string percent = std::to_string(std::lround(100.0 * share));
  std::string text = "[" + std::string(done, '#') + std::string(bar_width - done, ' ') + "] " +
                     std::string(3 - percent.size(), ' ') + percent + " %  " + what;
  if (share > min_share_to_judge && share < 1.0 && passed_s > min_time_to_judge_s) {
    text += ", about " + time_text(passed_s * (1.0 - share) / share) + " left";
  }
  return text;
}

ProgressLine::ProgressLine(std::ostream& stream)
    : stream_(stream), shown_(is_terminal(stream)), start_(Clock::now()), since_(start_) {
  if (shown_) clock_ = std::jthread([this](const std::stop_token& stop) { keep_drawing(stop); });
}

ProgressLine::~ProgressLine() {
  clear();
}

std::function<void(const std::string&, double)> ProgressLine::callback() {
  return [this](const std::string& what, double share) { show(what, share); };
}

void ProgressLine::show(const std::string& what, double share) {
  if (!shown_) return;
  const std::scoped_lock lock(mutex_);
  if (what != what_) since_ = Clock::now();
  what_ = what;
  share_ = share;
  draw();
}

void ProgressLine::draw() {
  const auto seconds_since = [now = Clock::now()](Clock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  const double lasts_s = seconds_since(since_);
  const std::string what = lasts_s < long_s ? what_ : what_ + " (" + time_text(lasts_s) + ")";
  stream_ << "\r\033[K" << config::printable(progress_text(what, share_, seconds_since(start_)))
          << std::flush;
}

void ProgressLine::keep_drawing(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    stopped_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    if (!stop.stop_requested() && !what_.empty()) draw();
  }
}

void ProgressLine::clear() {
  if (!shown_) return;
  const std::scoped_lock lock(mutex_);
  if (!what_.empty()) stream_ << "\r\033[K" << std::flush;
  what_.clear();
}

}  // namespace wheelwright::tools
