#include "tools/wheelwright/progress_line.hpp"

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
constexpr double least_share_to_judge = 0.05;
constexpr double least_time_to_judge_s = 1.0;

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
  if (share > least_share_to_judge && share < 1.0 && passed_s > least_time_to_judge_s) {
    text += ", about " + time_text(passed_s * (1.0 - share) / share) + " left";
  }
  return text;
}

ProgressLine::ProgressLine(std::ostream& stream)
    : stream_(stream), shown_(is_terminal(stream)), start_(std::chrono::steady_clock::now()) {}

std::function<void(const std::string&, double)> ProgressLine::callback() const {
  return [this](const std::string& what, double share) {
    if (!shown_) return;
    const double passed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    stream_ << "\r\033[K" << config::printable(progress_text(what, share, passed_s)) << std::flush;
  };
}

void ProgressLine::clear() const {
  if (shown_) stream_ << "\r\033[K" << std::flush;
}

}  // namespace wheelwright::tools
