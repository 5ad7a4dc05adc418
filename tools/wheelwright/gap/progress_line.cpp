#include "tools/wheelwright/gap/progress_line.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace wheelwright::tools {

ProgressLine::ProgressLine(std::ostream& stream)
    : stream_(stream),
      shown_(&stream == &std::cerr && ::isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {}

std::function<void(const std::string&, double)> ProgressLine::callback() const {
  return [this](const std::string& what, double share) {
    if (!shown_) return;
    const double passed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    stream_ << "\r\033[K" << std::lround(100.0 * share) << " %  " << what;
    if (share > 0.05) stream_ << ", about " << std::lround(passed_s * (1.0 - share) / share) << " s left";
    stream_ << std::flush;
  };
}

void ProgressLine::clear() const {
  if (shown_) stream_ << "\r\033[K" << std::flush;
}

}  // namespace wheelwright::tools
