#include "daemon/watch/idle_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <csignal>

namespace wheelwright::daemon {
namespace {

constexpr int lowest_priority = 19;
constexpr int cannot_start = 127;

// Between vfork and exec: only what a signal handler may call, and nothing that the daemon has in memory is
// changed.
void become_idle(int said, const IdleProcessLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setpgid(0, 0);
  if (limits.lowest_priority) {
    sched_param parameters{};
    ::sched_setscheduler(0, SCHED_IDLE, &parameters);
    ::setpriority(PRIO_PROCESS, 0, lowest_priority);
  }
  const rlimit memory{limits.memory_bytes, limits.memory_bytes};
  ::setrlimit(RLIMIT_DATA, &memory);
  // Where memory runs out, this process goes before the daemon does.
  const int score = ::open("/proc/self/oom_score_adj", O_WRONLY);
  [[maybe_unused]] const ssize_t written = score < 0 ? 0 : ::write(score, "900", 3);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ}) ::signal(number, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
  if (said >= 0) {
    ::dup2(said, STDOUT_FILENO);
    ::dup2(said, STDERR_FILENO);
  }
  ::close_range(3, UINT_MAX, 0);
}

}  // namespace

IdleProcess::IdleProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const std::filesystem::path& said, const IdleProcessLimits& limits)
    : until_(std::chrono::steady_clock::now() + limits.time) {
  std::string name = program.string();
  std::vector<std::string> words(arguments);
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int output = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644);
  // A fork would make each page of the sensor loop one that is copied when it is written to next.
  process_ = ::vfork();
  if (process_ == 0) {
    become_idle(output, limits);
    ::execv(name.c_str(), argv.data());
    ::_exit(cannot_start);
  }
  if (output >= 0) ::close(output);
  if (process_ < 0) status_ = cannot_start;
}

IdleProcess::~IdleProcess() {
  if (status_) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

std::optional<int> IdleProcess::ended() {
  if (status_) return status_;
  int status = 0;
  if (::waitpid(process_, &status, WNOHANG) == process_) {
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  } else if (std::chrono::steady_clock::now() >= until_) {
    ::kill(process_, SIGKILL);
  }
  return status_;
}

}  // namespace wheelwright::daemon
