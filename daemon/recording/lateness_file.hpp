// The sensor loop's wake-up lateness as a histogram in a text file: for the report of a run, and to be laid
// beside that of other programs. The daemon writes it into the folder of each run when the run ends.
//
// Lines `# key: value`, then one line per filled bin: upper edge in microseconds, and wake-ups.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/roomba/lateness_histogram.hpp"
#include "drivers/roomba/sensor_loop.hpp"

namespace wheelwright::daemon {

inline constexpr std::string_view lateness_file_name = "lateness.txt";

struct LatenessBin {
  double upper_edge_us = 0.0;  // no wake-up of the bin was later
  std::uint64_t wake_ups = 0;
};

struct LatenessRecord {
  std::string system;  // scheduling, memory and clock of the process, in words
  double period_s = 0.0;
  std::uint64_t wake_ups = 0;
  std::uint64_t overruns = 0;         // wake-ups that came a period or more late
  std::uint64_t skipped_periods = 0;  // periods lost to them
  std::uint64_t commands_late = 0;    // ticks at which no command had come in time
  double largest_us = 0.0;
  std::vector<LatenessBin> bins;  // filled ones, from early to late

  // The lateness that a share of all wake-ups (0 to 1) stayed below; to about 4 %.
  double quantile_us(double share) const;
};

LatenessRecord lateness_record(const roomba::LatenessHistogram& lateness, const roomba::LoopCounts& counts,
                               double period_s, const std::string& system);

std::string lateness_text(const LatenessRecord& record);

// The record of a text that lateness_text wrote. Throws config::LogError with `name` and the line.
LatenessRecord parse_lateness(const std::string& text, const std::string& name);

}  // namespace wheelwright::daemon
