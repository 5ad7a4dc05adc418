#include "tools/wheelwright/doctor/judge_host.hpp"

#include "config/load/text_format.hpp"

namespace wheelwright::tools::doctor {
namespace {

using config::fixed_number;
using config::RealTimePolicy;

// What is not to be had is a failure only for those who insist on it.
State shortfall_state(const config::RealTimeConfig& wanted) {
  return wanted.policy == RealTimePolicy::require ? State::failed : State::attention;
}

std::string microseconds(double duration_s) {
  return fixed_number(1e6 * duration_s, 0);
}

Finding judge_kernel(const HostFigures& host) {
  // A stock kernel will do for 18 ms; how late it really wakes a loop is judged below.
  return {"kernel", (host.real_time_kernel ? "PREEMPT_RT, " : "stock, ") + host.release, State::ok, ""};
}

Finding judge_scheduling(const HostFigures& host, const config::RealTimeConfig& wanted) {
  if (wanted.policy == RealTimePolicy::off) {
    return {"SCHED_FIFO", "not wanted (real_time.policy: off)", State::ok, ""};
  }
  if (host.priority > 0) {
    return {"SCHED_FIFO", "priority " + std::to_string(host.priority) + " obtained", State::ok, ""};
  }
  return {"SCHED_FIFO", "priority " + std::to_string(wanted.priority) + " refused", shortfall_state(wanted),
          "raise 'rtprio' to " + std::to_string(wanted.priority) +
              " in /etc/security/limits.conf and log in again, or LimitRTPRIO= in the unit"};
}

Finding judge_memory(const HostFigures& host, const config::RealTimeConfig& wanted) {
  if (wanted.policy == RealTimePolicy::off || !wanted.lock_memory) {
    return {"locked memory", "not wanted (real_time.lock_memory)", State::ok, ""};
  }
  if (host.memory_can_be_locked) return {"locked memory", host.lockable_memory, State::ok, ""};
  return {"locked memory", host.lockable_memory + ", too little", shortfall_state(wanted),
          "raise 'memlock' in /etc/security/limits.conf and log in again, or LimitMEMLOCK= in the unit"};
}

Finding judge_lateness(const HostFigures& host, double period_s) {
  const Spread& late = host.lateness;
  Finding finding{"wake-up lateness",
                  "p50 " + microseconds(late.p50_s) + ", p99 " + microseconds(late.p99_s) + ", largest " +
                      microseconds(late.largest_s) + " us at " + fixed_number(1e3 * period_s, 3) + " ms",
                  State::ok,
                  "",
                  {{"p50_us", 1e6 * late.p50_s},
                   {"p99_us", 1e6 * late.p99_s},
                   {"largest_us", 1e6 * late.largest_s},
                   {"skipped_periods", host.skipped_periods}}};
  if (host.skipped_periods > 0) {
    finding.state = State::failed;
    finding.text += ", " + std::to_string(host.skipped_periods) + " skipped";
    finding.remedy = "the machine is too busy for the loop: stop what loads it, or obtain SCHED_FIFO";
  } else if (late.largest_s > 0.25 * period_s) {
    finding.state = State::attention;
    finding.remedy = host.priority > 0
                         ? "something holds the processor in the kernel or the firmware: look for "
                           "frequency scaling, thermal limits, virtual machines"
                         : "obtain SCHED_FIFO, or stop what loads the machine";
  }
  return finding;
}

}  // namespace

std::vector<Finding> judge_host(const HostFigures& host, const config::RealTimeConfig& wanted,
                                double period_s) {
  return {judge_kernel(host), judge_scheduling(host, wanted), judge_memory(host, wanted),
          judge_lateness(host, period_s)};
}

}  // namespace wheelwright::tools::doctor
