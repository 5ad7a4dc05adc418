#include "daemon/lateness_file.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

namespace wheelwright::daemon {

std::string lateness_text(const roomba::Session& session, double period_s) {
  const auto& lateness = session.lateness();
  const auto microseconds = [](std::chrono::nanoseconds time) {
    return 1e-3 * static_cast<double>(time.count());
  };
  std::string text = fmt::format(
      "# wheelwright_lateness: 1\n# period_s: {}\n# wake_ups: {}\n# overruns: {}\n# skipped_periods: {}\n"
      "# largest_us: {:.1f}\n# columns: upper edge in us, wake-ups\n",
      period_s, lateness.count(), session.counts().overruns, session.counts().skipped_periods,
      microseconds(lateness.largest()));
  for (std::size_t bin = 0; bin < roomba::LatenessHistogram::bins; ++bin) {
    if (lateness.in_bin(bin) == 0) continue;
    const auto edge = std::min(roomba::LatenessHistogram::upper_edge(bin), lateness.largest());
    text += fmt::format("{:.1f} {}\n", microseconds(edge), lateness.in_bin(bin));
  }
  return text;
}

}  // namespace wheelwright::daemon
