#include "tests/loopback/bench/stalled_pipe.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace wheelwright::bench {

StalledPipe::StalledPipe(const std::filesystem::path& path) : path_(path) {
  if (::mkfifo(path.c_str(), 0600) != 0) throw std::runtime_error(path.string() + ": no FIFO");
  descriptor_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) throw std::runtime_error(path.string() + ": cannot be opened");
  const std::array<char, 4096> filling{};
  while (::write(descriptor_, filling.data(), filling.size()) > 0) continue;
  while (::write(descriptor_, filling.data(), 1) > 0) continue;
}

StalledPipe::~StalledPipe() {
  ::close(descriptor_);
}

std::vector<std::string> StalledPipe::as_standard_error() const {
  return {"sh", "-c", "exec \"$@\" 2>\"$0\"", path_.string()};
}

}  // namespace wheelwright::bench
