// One line on a terminal that says how far a long piece of work is; nothing in a pipe.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

namespace wheelwright::tools {

// "[########            ]  40 %  fitting, about 12 s left": a bar, the share done so far (0 to 1), a word for
// the work at hand, and the time that is left at this pace, once that can be said. Plain characters, no
// colour.
std::string progress_text(const std::string& what, double share, double passed_s);

class ProgressLine {
 public:
  // Shows itself where `stream` is the standard error of a terminal, and how long the work at hand has taken,
  // second by second.
  explicit ProgressLine(std::ostream& stream);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Called with a word for the work at hand and the share done so far.
  std::function<void(const std::string&, double)> callback();
  // Wipes the line, for something else to be written.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& what, double share);
  void draw();
  void keep_drawing(const std::stop_token& stop);

  std::ostream& stream_;
  bool shown_;
  Clock::time_point start_;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::string what_;  // empty while there is no line
  double share_ = 0.0;
  Clock::time_point since_;  // the work at hand goes on
  std::jthread clock_;       // last, so that it ends first
};

}  // namespace wheelwright::tools
