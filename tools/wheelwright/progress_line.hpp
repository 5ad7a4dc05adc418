// One line on a terminal that says how far a long piece of work is; nothing in a pipe.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

namespace wheelwright::tools {

// "[########            ]  40 %  fitting, about 12 s left": a bar, the share done so far (0 to 1), a word for
// the work at hand, and the time that is left at this pace, once that can be said. Plain characters, no
// colour.
std::string progress_text(const std::string& what, double share, double passed_s);

class ProgressLine {
 public:
  // Shows itself where `stream` is the standard error of a terminal.
  explicit ProgressLine(std::ostream& stream);

  // Called with a word for the work at hand and the share done so far.
  std::function<void(const std::string&, double)> callback() const;
  // Wipes the line.
  void clear() const;

 private:
  std::ostream& stream_;
  bool shown_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace wheelwright::tools
