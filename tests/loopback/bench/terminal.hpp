// A terminal with a program in it, as its operator starts one.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace wheelwright::bench {

class Terminal {
 public:
  // Starts `command` in a terminal of its own. Throws std::runtime_error where that does not work.
  explicit Terminal(const std::vector<std::string>& command);
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  pid_t pid() const { return pid_; }
  // The operator presses Ctrl-S: the terminal takes no further output.
  void hold_output() const;
  // The operator closes the window.
  void close();
  // The exit status, the negative signal number where a signal ended the program, or nothing where it still
  // runs.
  std::optional<int> wait(std::chrono::milliseconds at_most);

 private:
  int master_ = -1;
  pid_t pid_ = -1;
  std::optional<int> status_;
};

}  // namespace wheelwright::bench
