#include "daemon/model_watch/idle_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace wheelwright::daemon {
namespace {

constexpr int lowest_priority = 19;
constexpr int cannot_start = 127;
constexpr int goes_first = 900;  // of 1000

// Limits of a process that runs already. Where memory runs out, it goes before the daemon does.
void limit(pid_t process, const IdleProcessLimits& limits) {
  if (limits.lowest_priority) ::setpriority(PRIO_PROCESS, static_cast<id_t>(process), lowest_priority);
  const rlimit memory{limits.memory_bytes, limits.memory_bytes};
  ::prlimit(process, RLIMIT_DATA, &memory, nullptr);
  std::ofstream("/proc/" + std::to_string(process) + "/oom_score_adj") << goes_first;
}

// Not a fork, after which each page of the sensor loop would be copied when it is written to next.
class SpawnOptions {
 public:
  SpawnOptions(const std::filesystem::path& said, const IdleProcessLimits& limits) {
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0644);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    ::posix_spawnattr_init(&attributes);
    int flags = POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF;
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    sigset_t ignored_here;
    ::sigemptyset(&ignored_here);
    for (const int number : {SIGPIPE, SIGXFSZ}) ::sigaddset(&ignored_here, number);
    ::posix_spawnattr_setsigdefault(&attributes, &ignored_here);
    if (limits.lowest_priority) {
      const sched_param parameters{};
      flags |= POSIX_SPAWN_SETSCHEDULER;
      ::posix_spawnattr_setschedpolicy(&attributes, SCHED_IDLE);
      ::posix_spawnattr_setschedparam(&attributes, &parameters);
    }
    ::posix_spawnattr_setflags(&attributes, static_cast<short>(flags));
  }
  SpawnOptions(const SpawnOptions&) = delete;
  SpawnOptions& operator=(const SpawnOptions&) = delete;
  ~SpawnOptions() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

}  // namespace

IdleProcess::IdleProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                         const std::filesystem::path& said, const IdleProcessLimits& limits)
    : until_(std::chrono::steady_clock::now() + limits.time) {
  std::string name = program.string();
  std::vector<std::string> words(arguments);
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const SpawnOptions options(said, limits);
  if (::posix_spawn(&process_, name.c_str(), &options.actions, &options.attributes, argv.data(), environ) !=
      0) {
    status_ = cannot_start;
    return;
  }
  limit(process_, limits);
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
