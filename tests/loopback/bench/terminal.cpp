#include "tests/loopback/bench/terminal.hpp"

#include <pty.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <utility>

#include "tests/loopback/bench/eventually.hpp"

namespace wheelwright::bench {
namespace {

constexpr char ctrl_s = '\x13';

}  // namespace

Terminal::Terminal(const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_ = ::forkpty(&master_, nullptr, nullptr, nullptr);
  if (pid_ < 0) throw std::runtime_error("no terminal for " + command.at(0));
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing of a test outlives it
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
}

Terminal::~Terminal() {
  if (!wait(std::chrono::milliseconds(0))) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  close();
}

void Terminal::hold_output() const {
  if (::write(master_, &ctrl_s, 1) != 1) throw std::runtime_error("the terminal takes no key");
}

void Terminal::close() {
  if (master_ >= 0) ::close(std::exchange(master_, -1));
}

std::optional<int> Terminal::wait(std::chrono::milliseconds at_most) {
  eventually(at_most, [this] {
    if (status_) return true;
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return true;
  });
  return status_;
}

}  // namespace wheelwright::bench
