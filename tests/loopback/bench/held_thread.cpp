#include "tests/loopback/bench/held_thread.hpp"

#include <sys/ptrace.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>

namespace wheelwright::bench {
namespace {

pid_t thread_of(pid_t process, const std::string& name) {
  std::error_code ignored;
  const auto tasks = "/proc/" + std::to_string(process) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks, ignored)) {
    std::string found;
    std::getline(std::ifstream(task.path() / "comm"), found);
    if (found == name) return std::stoi(task.path().filename());
  }
  return -1;
}

}  // namespace

HeldThread::HeldThread(pid_t process, const std::string& name) {
  const pid_t thread = thread_of(process, name);
  if (thread < 0 || ::ptrace(PTRACE_SEIZE, thread, 0, 0) != 0) return;
  if (::ptrace(PTRACE_INTERRUPT, thread, 0, 0) != 0) return;
  if (::waitpid(thread, nullptr, __WALL) == thread) thread_ = thread;
}

HeldThread::~HeldThread() {
  if (thread_ > 0) ::ptrace(PTRACE_DETACH, thread_, 0, 0);
}

}  // namespace wheelwright::bench
