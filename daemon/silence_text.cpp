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

constexpr std::string_view or_late =
    ", and at the adapter's delay, since replies later than a period look damaged: wheelwright doctor";

constexpr std::string_view relieve =
    "end other programs and give the daemon real-time scheduling (systemd/README.md)";

}  // namespace

MachineLoad machine_load() {
  MachineLoad load;
  if (::getloadavg(&load.processes, 1) != 1) load.processes = 0.0;
  load.cores = static_cast<int>(std::max(1L, ::sysconf(_SC_NPROCESSORS_ONLN)));
  return load;
}

std::string explain(const roomba::Silence& silence, const SilenceContext& context) {
  const double late_ms = milliseconds(silence.largest_lateness);
  const std::string loop = fmt::format("the loop woke up at most {:.1f} ms late", late_ms);
  const std::string load = fmt::format("load {:.1f} on {} cores", context.load.processes, context.load.cores);
  if (silence.skipped_periods > 0 || late_ms > 500.0 * context.period_s) {
    return fmt::format("the machine was too busy ({}): {} and skipped {} periods; {}", load, loop,
                       silence.skipped_periods, relieve);
  }
  const auto& replies = silence.replies;
  if (replies.sound > replies.missing + replies.incomplete + replies.garbled) {
    return fmt::format(
        "replies came, but with encoder counts that no wheel can have made ({}); the cable or the serial "
        "adapter damages bytes: see wheelwright doctor",
        loop);
  }
  if (replies.incomplete + replies.garbled == 0) {
    return fmt::format(
        "nothing sound came from the robot ({}, {}); look whether the cable is plugged in at both ends and "
        "the robot "
        "is on: wheelwright doctor{}",
        loop, load, context.load.is_busy() ? "; a simulated robot wants a machine that is less busy" : "");
  }
  const std::string what = describe_replies(replies);
  if (context.load.is_busy()) {
    return fmt::format(
        "{} while the machine was busy ({}, {}); {}, and if it comes again look at the cable{}", what, load,
        loop, relieve, or_late);
  }
  return fmt::format("{} while the machine was in time ({}, {}); look at the cable and its plugs{}", what,
                     loop, load, or_late);
}

}  // namespace wheelwright::daemon
