// A drive log: read, played back by a robot, and written again.
#include <cmath>

#include "config/load/drive_log_file.hpp"
#include "drivers/simulation/recording.hpp"
#include "model/log/command_timeline.hpp"
#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    for (const DriveLog& log : config::parse_drive_logs(fuzz::as_text(data, size), "fuzz.csv")) {
      fuzz::must_hold(!log.samples.empty(), "a run has samples");
      fuzz::must_hold(log.period_s > 0.0 && std::isfinite(log.period_s), "the period is positive");
      for (std::size_t i = 1; i < log.samples.size(); ++i) {
        fuzz::must_hold(log.samples[i].t_s > log.samples[i - 1].t_s, "time rises");
      }
      for (const auto& column : log.extra_columns) {
        fuzz::must_hold(column.values.size() == log.samples.size(), "a column has a value for each row");
      }
      try {
        simulation::recording_of(log);
      } catch (const std::runtime_error&) {  // a log without counts
      }
    }
  } catch (const config::LogError&) {
  }
  return 0;
}
