#include "daemon/threads/real_time_setup.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/utsname.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace wheelwright::daemon {
namespace {

// Locked memory counts every stack in full; nothing here needs more than this.
#ifdef __SANITIZE_THREAD__
constexpr std::size_t stack_bytes = 4096UL * 1024UL;  // the sanitizer's own share of a stack is larger
#else
constexpr std::size_t stack_bytes = 512UL * 1024UL;
#endif

void add_shortfall(RealTimeStatus& status, const std::string& what) {
  status.shortfall += (status.shortfall.empty() ? "" : "; ") + what;
}

}  // namespace

bool is_real_time_kernel() {
  utsname name{};
  // Newer kernels say it only in their version, older ones only in /sys.
  if (::uname(&name) == 0 && std::string_view(name.version).find("PREEMPT_RT") != std::string_view::npos)
    return true;
  std::error_code ignored;
  return std::filesystem::exists("/sys/kernel/realtime", ignored);
}

void set_up_allocation() {
  pthread_attr_t attributes{};
  if (::pthread_attr_init(&attributes) == 0) {
    ::pthread_attr_setstacksize(&attributes, stack_bytes);
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
  }
  // A heap that shrinks and grows again would fault pages in afresh, and one arena per thread locks more of
  // them.
  ::mallopt(M_TRIM_THRESHOLD, -1);
  ::mallopt(M_MMAP_MAX, 0);
  ::mallopt(M_ARENA_MAX, 1);
}

RealTimeStatus set_up_process(const config::RealTimeConfig& config) {
  RealTimeStatus status;
  status.real_time_kernel = is_real_time_kernel();
  if (config.policy == config::RealTimePolicy::off || !config.lock_memory) return status;
  status.memory_locked = ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  if (!status.memory_locked) {
    add_shortfall(status, std::string("memory is not locked (") + std::strerror(errno) +
                              "): raise 'memlock' in limits.conf, or LimitMEMLOCK= in the unit");
  }
  return status;
}

void set_up_loop_thread(const config::RealTimeConfig& config, RealTimeStatus& status) {
  if (config.policy == config::RealTimePolicy::off) return;
  sched_param parameters{};
  parameters.sched_priority = config.priority;
  const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
  if (error == 0) {
    status.priority = config.priority;
  } else {
    add_shortfall(status, std::string("no real-time scheduling (") + std::strerror(error) +
                              "): raise 'rtprio' in limits.conf, or LimitRTPRIO= in the unit");
  }
}

void set_up_predictor_thread(const RealTimeStatus& status) {
  if (status.priority <= 1) return;
  sched_param parameters{};
  parameters.sched_priority = status.priority - 1;
  ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
}

std::string describe(const RealTimeStatus& status) {
  std::string text = status.real_time_kernel ? "PREEMPT_RT kernel" : "stock kernel";
  text += status.priority > 0 ? ", SCHED_FIFO " + std::to_string(status.priority) : ", ordinary scheduler";
  text += status.memory_locked ? ", memory locked" : ", memory not locked";
  return text;
}

void name_thread(const char* name) {
  ::pthread_setname_np(::pthread_self(), name);
}

}  // namespace wheelwright::daemon
