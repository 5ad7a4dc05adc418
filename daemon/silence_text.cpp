#include "daemon/silence_text.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cstdlib>

namespace wheelwright::daemon {
namespace {

double milliseconds(std::chrono::nanoseconds duration) {
  return 1e-6 * static_cast<double>(duration.count());
}

std::string describe_replies(const open_interface::ReplyCounts& replies) {
  const auto asked = replies.sound + replies.missing + replies.incomplete + replies.garbled;
  return fmt::format("of {} replies {} did not come, {} were incomplete or late, {} were damaged", asked,
                     replies.missing, replies.incomplete, replies.garbled);
}

constexpr std::string_view relieve =
    "end other programs (a browser with the live view takes part of a core) and give the daemon real-time "
    "scheduling (systemd/README.md)";

}  // namespace

MachineLoad machine_load() {
  MachineLoad load;
  if (::getloadavg(&load.processes, 1) != 1) load.processes = 0.0;
  load.cores = static_cast<int>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  return load;
}

std::string explain(const roomba::Silence& silence, const SilenceContext& context) {
  const double late_ms = milliseconds(silence.largest_lateness);
  const std::string loop = fmt::format("the loop woke up to {:.1f} ms late", late_ms);
  const std::string load = fmt::format("load {:.1f} on {} cores", context.load.processes, context.load.cores);
  if (silence.skipped_periods > 0 || late_ms > 500.0 * context.period_s) {
    return fmt::format("the machine was too busy: {} and skipped {} periods ({}); {}", loop,
                       silence.skipped_periods, load, relieve);
  }
  const auto& replies = silence.replies;
  const auto failed = replies.missing + replies.incomplete + replies.garbled;
  if (replies.sound > failed) {
    return fmt::format(
        "replies came, but with encoder counts that no wheel can have made ({}); the cable or the "
        "serial adapter damages bytes: see wheelwright doctor",
        loop);
  }
  if (context.load.is_busy()) {
    return fmt::format(
        "the loop was in time ({}), but the machine was busy ({}), and {}; {}, and if it comes again "
        "look at cable and robot: wheelwright doctor",
        loop, load, describe_replies(replies), relieve);
  }
  if (replies.incomplete + replies.garbled == 0) {
    return fmt::format(
        "nothing came from the robot while the machine was in time ({}, {}); look whether the cable "
        "is plugged in at both ends and the robot is on: wheelwright doctor",
        loop, load);
  }
  return fmt::format(
      "the machine was in time ({}, {}), but {}; look at the cable and its plugs: wheelwright doctor", loop,
      load, describe_replies(replies));
}

}  // namespace wheelwright::daemon
