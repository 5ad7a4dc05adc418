#include "daemon/guardian/guardian_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <csignal>
#include <cstring>
#include <string_view>

#include "drivers/roomba/rest_bytes.hpp"
#include "drivers/roomba/rest_sequence.hpp"

namespace wheelwright::daemon {
namespace {

using namespace std::chrono_literals;

constexpr auto look_every = 5ms;
constexpr auto longest_look = 20ms;  // of silence that one look can tell: beyond it the machine stood still

// What is inherited is what the daemon may go down with: its terminal, its signals, its descriptors. Only
// what a signal handler may call is called here, since the process may have had threads.
void leave_the_daemon(const GuardianConfig& config, int socket) {
  ::setsid();
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_IGN);
  ::prctl(PR_SET_NAME, "ww-guardian");
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing >= 0) {
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
  }
  if (socket > 3) ::close_range(3, static_cast<unsigned>(socket) - 1, 0);
  ::close_range(static_cast<unsigned>(socket) + 1, UINT_MAX, 0);
  if (::chdir("/") != 0) return;
  if (config.lock_memory) ::mlockall(MCL_CURRENT | MCL_FUTURE);
  if (config.priority > 0) {
    sched_param parameters{};
    parameters.sched_priority = config.priority;
    ::sched_setscheduler(0, SCHED_FIFO, &parameters);
  }
}

// Standard error, written to without ever waiting for who reads it. A pipe or a terminal is opened once more
// for that, since a flag of the descriptor would be one for all processes that share it. A line that is not
// taken is lost.
class Voice {
 public:
  Voice() {
    struct stat about {};
    if (::fstat(STDERR_FILENO, &about) != 0) return;
    is_socket_ = S_ISSOCK(about.st_mode);
    if (S_ISREG(about.st_mode) || is_socket_) {
      descriptor_ = STDERR_FILENO;
    } else {
      descriptor_ = ::open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    }
  }

  void say(std::string_view line) const {
    if (descriptor_ < 0) return;
    const ssize_t taken = is_socket_
                              ? ::send(descriptor_, line.data(), line.size(), MSG_DONTWAIT | MSG_NOSIGNAL)
                              : ::write(descriptor_, line.data(), line.size());
    if (taken < 0) return;
  }

 private:
  int descriptor_ = -1;
  bool is_socket_ = false;
};

class Process {
 public:
  Process(const GuardianConfig& config, int socket, GuardianBoard& board)
      : socket_(socket), board_(board), rest_(roomba::rest_bytes(config.drive_mode)) {}

  [[noreturn]] void run() {
    while (true) {
      board_.looks.fetch_add(1, std::memory_order_relaxed);
      std::array<pollfd, 2> watched{{{socket_, POLLIN, 0}, {port_, 0, 0}}};
      const int ready = ::poll(watched.data(), port_ < 0 ? 1 : 2, static_cast<int>(look_every.count()));
      if (watched[0].revents != 0) obey();
      if (port_ >= 0 && watched[1].revents != 0) let_go();
      if (ready == 0) look();
    }
  }

 private:
  // Orders of the daemon; the end of the socket is the end of the daemon.
  void obey() {
    char letter = 0;
    iovec data{&letter, 1};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{};
    message.msg_iov = &data;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t count = ::recvmsg(socket_, &message, MSG_DONTWAIT);
    if (count <= 0) outlive_the_daemon();
    switch (static_cast<GuardianOrder>(letter)) {
      case GuardianOrder::adopt:
        let_go();
        if (const cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr) {
          std::memcpy(&port_, CMSG_DATA(header), sizeof(int));
        }
        break;
      case GuardianOrder::drop:
        if (port_ >= 0) roomba::write_whole(port_, rest_.bytes());
        let_go();
        break;
      case GuardianOrder::let_go:
        let_go();
        break;
      case GuardianOrder::farewell:
        ::_exit(0);
    }
  }

  void let_go() {
    if (port_ >= 0) ::close(port_);
    port_ = -1;
  }

  // One look at the counter, every 5 ms or, on a busy machine, somewhat later.
  void look() {
    const auto now = std::chrono::steady_clock::now();
    const auto since_last = std::min<std::chrono::nanoseconds>(now - last_look_, longest_look);
    last_look_ = now;
    const std::uint64_t beats = board_.beats.load(std::memory_order_relaxed);
    if (beats != last_beats_ || beats == 0) {
      if (acts_ > 0) voice_.say("<4>guardian: the sensor loop goes on\n");
      last_beats_ = beats;
      silent_for_ = 0ns;
      acts_ = 0;
      return;
    }
    silent_for_ += since_last;
    if (port_ < 0 || acts_ == roomba::rest_orders) return;
    const std::chrono::milliseconds patience(board_.patience_ms.load(std::memory_order_relaxed));
    if (silent_for_ < patience + acts_ * roomba::rest_order_period) return;
    board_.acts.fetch_add(1, std::memory_order_relaxed);
    roomba::write_whole(port_, rest_.bytes());
    if (acts_ == 0) voice_.say("<3>guardian: the sensor loop stands still; the wheels are told to stand\n");
    ++acts_;
  }

  [[noreturn]] void outlive_the_daemon() {
    if (port_ < 0) ::_exit(0);
    roomba::write_whole(port_, rest_.bytes());
    voice_.say("<3>guardian: the daemon is gone; the wheels are told to stand\n");
    roomba::rest_and_leave(port_, rest_);
    ::_exit(0);
  }

  int socket_;
  GuardianBoard& board_;
  Voice voice_;
  open_interface::CommandBytes rest_;
  int port_ = -1;
  std::uint64_t last_beats_ = 0;
  std::chrono::steady_clock::time_point last_look_ = std::chrono::steady_clock::now();
  std::chrono::nanoseconds silent_for_{0};
  int acts_ = 0;
};

}  // namespace

void guard(const GuardianConfig& config, int socket, GuardianBoard& board) {
  leave_the_daemon(config, socket);
  Process(config, socket, board).run();
}

}  // namespace wheelwright::daemon
