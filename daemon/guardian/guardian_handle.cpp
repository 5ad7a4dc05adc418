#include "daemon/guardian/guardian_handle.hpp"

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <string>
#include <utility>

#include "daemon/guardian/guardian_process.hpp"
#include "daemon/service/exit_status.hpp"

namespace wheelwright::daemon {
namespace {

constexpr double patience_periods = 3.0;
constexpr std::chrono::milliseconds shortest_patience{50};
constexpr std::chrono::milliseconds response_patience{500};
constexpr std::chrono::milliseconds longest_interval{
    100};  // between two questions: beyond it the machine stood still
constexpr useconds_t end_look_us = 10'000;
constexpr int looks_in_order = 50;
constexpr int looks_while_braking = 150;

[[noreturn]] void fail(const std::string& what) {
  throw StartFailure(EndCause::internal, what + ": " + std::strerror(errno));
}

GuardianBoard* shared_board() {
  void* memory =
      ::mmap(nullptr, sizeof(GuardianBoard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) fail("no shared memory for the guardian");
  return new (memory) GuardianBoard;
}

// A guardian that is gone takes no orders; alive() tells.
void send_order(int socket, GuardianOrder order, int descriptor = -1) {
  char letter = static_cast<char>(order);
  iovec data{&letter, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof(int));
  }
  ::sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace

std::chrono::milliseconds guardian_patience(const roomba::LinkConfig& link, bool real_time) {
  const std::chrono::duration<double> wanted(real_time ? patience_periods * link.period_s
                                                       : std::max(link.blind_limit_s, 4.0 * link.period_s));
  return std::max(shortest_patience, std::chrono::ceil<std::chrono::milliseconds>(wanted));
}

GuardianHandle::GuardianHandle(const GuardianConfig& config) : board_(shared_board()) {
  set_patience(config.patience);
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    fail("no socket for the guardian");
  }
  process_ = ::fork();
  if (process_ < 0) fail("no process for the guardian; raise the limit of processes (ulimit -u, TasksMax=)");
  if (process_ == 0) guard(config, ends[1], *board_);
  ::close(ends[1]);
  socket_ = ends[0];
}

GuardianHandle::~GuardianHandle() {
  const int looks = socket_ >= 0 ? looks_in_order : looks_while_braking;
  if (socket_ >= 0) {
    send_order(socket_, GuardianOrder::farewell);
    ::close(socket_);
  }
  for (int look = 0; look < looks && alive(); ++look) ::usleep(end_look_us);
  if (alive()) {
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  ::munmap(board_, sizeof(GuardianBoard));
}

void GuardianHandle::port_opened(int descriptor) {
  send_order(socket_, GuardianOrder::adopt, descriptor);
}

void GuardianHandle::port_closed() {
  send_order(socket_, GuardianOrder::let_go);
}

void GuardianHandle::port_dropped() {
  send_order(socket_, GuardianOrder::drop);
}

void GuardianHandle::set_patience(std::chrono::milliseconds patience) {
  board_->patience_ms.store(patience.count(), std::memory_order_relaxed);
}

bool GuardianHandle::has_acted() {
  const std::uint64_t acts = board_->acts.load(std::memory_order_relaxed);
  return std::exchange(acts_seen_, acts) != acts;
}

bool GuardianHandle::alive() {
  ended_ = ended_ || ::waitpid(process_, nullptr, WNOHANG) == process_;
  return !ended_;
}

bool GuardianHandle::responds() {
  const auto now = std::chrono::steady_clock::now();
  const auto since_last = std::min<std::chrono::nanoseconds>(now - asked_, longest_interval);
  asked_ = now;
  const std::uint64_t looks = board_->looks.load(std::memory_order_relaxed);
  silent_for_ = looks == looks_seen_ ? silent_for_ + since_last : std::chrono::nanoseconds(0);
  looks_seen_ = looks;
  return silent_for_ < response_patience;
}

void GuardianHandle::leave_wheels_to_guardian() {
  ::close(std::exchange(socket_, -1));
}

}  // namespace wheelwright::daemon
