#include "tests/loopback/bench/child_process.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/loopback/bench/eventually.hpp"

namespace wheelwright::bench {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

int created(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) throw std::runtime_error(path.string() + ": cannot be created");
  return descriptor;
}

}  // namespace

void schedule_calling_thread(Scheduling scheduling) {
  if (scheduling == Scheduling::ordinary) return;
  sched_param parameters{};
  parameters.sched_priority = 60;  // above the daemon's loop
  ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output,
                           Scheduling scheduling)
    : out_(output.string() + ".out"), err_(output.string() + ".err") {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int out = created(out_);
  const int err = created(err_);
  pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing of a test outlives it
    ::setsid();                          // away from the terminal, if any, that the tests run in
    schedule_calling_thread(scheduling);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(out);
  ::close(err);
  if (pid_ < 0) throw std::runtime_error("cannot start " + command.at(0));
}

ChildProcess::~ChildProcess() {
  if (status_) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void ChildProcess::signal(int number) const {
  if (!status_) ::kill(pid_, number);
}

int ChildProcess::wait(std::chrono::milliseconds at_most) {
  eventually(at_most, [this] {
    if (status_) return true;
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return true;
  });
  return status_.value_or(still_running);
}

int ChildProcess::end() {
  signal(SIGTERM);
  return wait(std::chrono::seconds(5));
}

std::optional<pid_t> ChildProcess::child() const {
  const std::string pid = std::to_string(pid_);
  std::ifstream children("/proc/" + pid + "/task/" + pid + "/children");
  pid_t first = 0;
  if (children >> first) return first;
  return std::nullopt;
}

double ChildProcess::resident_mb() const {
  long total = 0;
  long resident = 0;
  std::ifstream("/proc/" + std::to_string(pid_) + "/statm") >> total >> resident;
  return 1e-6 * static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

std::string ChildProcess::out() const {
  return text_of(out_);
}

std::string ChildProcess::err() const {
  return text_of(err_);
}

bool ChildProcess::says(const std::string& text, std::chrono::milliseconds at_most) const {
  return eventually(at_most, [&] { return err().find(text) != std::string::npos; });
}

}  // namespace wheelwright::bench
