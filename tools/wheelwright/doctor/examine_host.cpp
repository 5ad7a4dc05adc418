#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <time.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "daemon/threads/real_time_setup.hpp"
#include "tools/wheelwright/doctor/interruption.hpp"
#include "tools/wheelwright/doctor/judge_host.hpp"

namespace wheelwright::tools::doctor {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double examined_s = 2.0;
constexpr std::size_t memory_of_the_daemon = 64UL * 1024UL * 1024UL;  // all that it maps, stacks included

// The limit alone does not tell: a capability may lift it, and what is locked already counts too.
bool can_lock_memory() {
  void* const trial =
      ::mmap(nullptr, memory_of_the_daemon, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (trial == MAP_FAILED) return false;
  const bool locked = ::mlock(trial, memory_of_the_daemon) == 0;
  ::munmap(trial, memory_of_the_daemon);
  return locked;
}

std::string describe_memory_limit(bool can_lock) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_MEMLOCK, &limit) != 0) return "limit not known";
  if (limit.rlim_cur == RLIM_INFINITY) return "no limit";
  const std::string text = "limit " + std::to_string(limit.rlim_cur / 1024UL / 1024UL) + " MiB";
  return can_lock && limit.rlim_cur < memory_of_the_daemon ? text + ", lifted by privilege" : text;
}

// std::this_thread sleeps for a duration, which adds whatever lies between computing and sleeping it.
void sleep_until(Clock::time_point deadline) {
  const auto since_boot = deadline.time_since_epoch();
  const auto whole_s = std::chrono::floor<std::chrono::seconds>(since_boot);
  const timespec wake{whole_s.count(), std::chrono::nanoseconds(since_boot - whole_s).count()};
  ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr);
}

void measure_lateness(HostFigures& host, double period_s) {
  const auto period = std::chrono::round<Clock::duration>(std::chrono::duration<double>(period_s));
  std::vector<double> lateness_s;
  const auto wake_ups = static_cast<std::size_t>(std::ceil(examined_s / period_s));
  lateness_s.reserve(wake_ups);
  auto deadline = Clock::now() + period;
  for (std::size_t i = 0; i < wake_ups; ++i) {
    sleep_until(deadline);
    const auto late = Clock::now() - deadline;
    lateness_s.push_back(std::chrono::duration<double>(late).count());
    host.skipped_periods += static_cast<int>(late / period);
    deadline += period * (1 + late / period);
  }
  host.lateness = spread_of(std::move(lateness_s));
}

}  // namespace

HostFigures examine_host(const config::RealTimeConfig& wanted, double period_s) {
  HostFigures host;
  host.real_time_kernel = daemon::is_real_time_kernel();
  utsname name{};
  if (::uname(&name) == 0) host.release = name.release;
  host.memory_can_be_locked = can_lock_memory();
  host.lockable_memory = describe_memory_limit(host.memory_can_be_locked);
  // In a thread of its own, so that the rest of the program stays an ordinary one.
  std::thread loop([&] {
    daemon::RealTimeStatus status;
    daemon::set_up_loop_thread(wanted, status);
    host.priority = status.priority;
    measure_lateness(host, period_s);
  });
  loop.join();
  throw_if_interrupted();
  return host;
}

}  // namespace wheelwright::tools::doctor
