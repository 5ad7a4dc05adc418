// A program under test: started without a shell, its output caught in files, gone when this object goes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wheelwright::bench {

// A robot does not wait for the host's processor: where the system lets it, its stand-in goes first.
enum class Scheduling { ordinary, like_hardware };
void schedule_calling_thread(Scheduling scheduling);

class ChildProcess {
 public:
  // Starts `command` (a path and its arguments). What it prints goes to `output` with .out and .err appended.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output,
               Scheduling scheduling = Scheduling::ordinary);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  pid_t pid() const { return pid_; }
  void signal(int number) const;

  static constexpr int still_running = 1000;

  // Waits for the end. Returns the exit status, the negative signal number where a signal ended it, or
  // still_running.
  int wait(std::chrono::milliseconds at_most);
  // Asks for the end (SIGTERM) and waits for it.
  int end();

  // A process that it has started; nothing where there is none, or the kernel does not say.
  std::optional<pid_t> child() const;
  // Memory that it has in use, in megabytes.
  double resident_mb() const;
  // What it has printed so far.
  std::string out() const;
  std::string err() const;
  // Waits until it has printed `text` on standard error.
  bool says(const std::string& text, std::chrono::milliseconds at_most) const;

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
  std::filesystem::path out_;
  std::filesystem::path err_;
};

}  // namespace wheelwright::bench
