// A pipe that is full and that nobody reads, as a supervisor leaves it that hangs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wheelwright::bench {

class StalledPipe {
 public:
  // Makes a FIFO at `path` and fills it. Throws std::runtime_error where that does not work.
  explicit StalledPipe(const std::filesystem::path& path);
  StalledPipe(const StalledPipe&) = delete;
  StalledPipe& operator=(const StalledPipe&) = delete;
  ~StalledPipe();

  // In front of a command: its standard error goes to the pipe.
  std::vector<std::string> as_standard_error() const;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace wheelwright::bench
