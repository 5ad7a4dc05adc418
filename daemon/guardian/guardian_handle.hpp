// A process of its own that stops the wheels when the daemon cannot: killed, crashed, out of memory, stopped,
// or with a sensor loop that hangs. The Open Interface knows no time-out; a robot drives on with its last
// command.
//
// The guardian has a duplicate of the port, a socket to the daemon, and a counter in shared memory that the
// sensor loop advances with every tick. When the socket closes, which shows that the daemon is gone, or when
// the counter stands still for longer than its patience, it writes the order to stand, three times 40 ms
// apart. It watches from the first tick on. Where the daemon is gone it then waits for 0.6 s, without reading
// a sensor, leaves the robot in Passive mode, and ends. A daemon that goes on finds has_acted() true and
// stops the run.
//
// The daemon watches the guardian too: where that has ended or stands still (responds()), it stops the robot
// and ends with an internal error.
//
// Its patience counts the time between two of its own looks at the counter only up to 20 ms: a machine that
// stood still as a whole, the guardian with it, is no silence. One on which both get no processor is not
// either.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdint>

#include "drivers/roomba/link_config.hpp"
#include "drivers/roomba/port_guard.hpp"

namespace wheelwright::daemon {

struct GuardianConfig {
  roomba::DriveMode drive_mode = roomba::DriveMode::direct;
  std::chrono::milliseconds patience{250};  // without a beat; see GuardianHandle::set_patience
  int priority = 0;                         // SCHED_FIFO, where it is to be had; 0: does not ask for it
  bool lock_memory = false;
};

// How long a sensor loop may stand still. One with real-time scheduling is never some ticks late unless it
// hangs: three periods, and 50 ms at least. An ordinary thread of a busy machine may be: as long as the robot
// may drive blind.
std::chrono::milliseconds guardian_patience(const roomba::LinkConfig& link, bool real_time);

// What daemon and guardian share. Lock-free, hence the same in both processes.
struct GuardianBoard {
  std::atomic<std::uint64_t> beats{0};
  std::atomic<std::uint64_t> acts{0};
  std::atomic<std::uint64_t> looks{0};  // passes of the guardian's loop
  std::atomic<std::int64_t> patience_ms{0};
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

class GuardianHandle final : public roomba::PortGuard {
 public:
  // Starts the process. Call it before memory is locked. Throws StartFailure where the system has no process
  // or socket left.
  explicit GuardianHandle(const GuardianConfig& config);
  GuardianHandle(const GuardianHandle&) = delete;
  GuardianHandle& operator=(const GuardianHandle&) = delete;
  // The daemon ends in order: so does the guardian, without touching the wheels. One that does not within
  // half a second is killed. After leave_wheels_to_guardian() it first stops the wheels, and has 1.5 s.
  ~GuardianHandle() override;

  void port_opened(int descriptor) override;
  void port_closed() override;
  void port_dropped() override;
  void beat() override { board_->beats.fetch_add(1, std::memory_order_relaxed); }
  bool has_acted() override;

  // Once it is known what scheduling the sensor loop got.
  void set_patience(std::chrono::milliseconds patience);

  // False once the process has ended by itself or was ended by somebody.
  bool alive();
  // False where it has not looked at the beats for half a second, though the caller, who asks several times
  // in that time, went on.
  bool responds();
  // The daemon cannot end in order: the guardian is to stop the wheels as if the daemon were gone.
  void leave_wheels_to_guardian();

 private:
  GuardianBoard* board_;
  int socket_ = -1;
  pid_t process_ = -1;
  bool ended_ = false;
  std::uint64_t acts_seen_ = 0;
  std::uint64_t looks_seen_ = 0;
  std::chrono::steady_clock::time_point asked_{};
  std::chrono::nanoseconds silent_for_{0};
};

}  // namespace wheelwright::daemon
