// A program that runs beside the daemon on what the others leave: lowest priority, bounded memory and time.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wheelwright::daemon {

struct IdleProcessLimits {
  std::size_t memory_bytes = 100U << 20U;  // of data; more, and it ends
  std::chrono::seconds time{3600};
  bool lowest_priority = true;
};

class IdleProcess {
 public:
  // What it says on either output goes into `said`. A program that cannot be started ends with status 127.
  IdleProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
              const std::filesystem::path& said, const IdleProcessLimits& limits = {});
  IdleProcess(const IdleProcess&) = delete;
  IdleProcess& operator=(const IdleProcess&) = delete;
  // Ends the program.
  ~IdleProcess();

  // Its exit status once it has ended, 128 and the number of the signal where one ended it; never blocks.
  // Beyond its time it is ended.
  std::optional<int> ended();

 private:
  std::chrono::steady_clock::time_point until_;
  pid_t process_ = -1;
  std::optional<int> status_;
};

}  // namespace wheelwright::daemon
