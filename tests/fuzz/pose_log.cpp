// The logs of a run as export and report read them: a pose log, or a drive log and behind a form feed the
// pose log of the same run, put together tick by tick and written in every format.
#include <cmath>
#include <limits>

#include "config/load/drive_log_file.hpp"
#include "tests/fuzz/fuzz_input.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/export/plain_csv.hpp"
#include "tools/wheelwright/export/recorded_run.hpp"
#include "tools/wheelwright/export/tum.hpp"

using namespace wheelwright;

namespace {

tools::RecordedRun parse_run(const std::string& text) {
  tools::RecordedRun run;
  const auto between = text.find('\f');
  if (between != std::string::npos) {
    run.drive = config::CsvTable::parse(text.substr(0, between), "drive_log.csv");
    run.poses = config::CsvTable::parse(text.substr(between + 1), "pose_log.csv");
  } else {
    run.poses = config::CsvTable::parse(text, "pose_log.csv");
  }
  return run;
}

void record(const tools::RecordedRun& run) {
  std::size_t bytes = 0;
  mcap::RobotRecording recording(
      [&](std::string_view part) {
        bytes += part.size();
        return true;
      },
      tools::metadata_of(run), mcap::steering_pose("hybrid"));
  double last_s = -std::numeric_limits<double>::infinity();
  tools::for_each_tick(run, [&](const mcap::TickValues& tick) {
    fuzz::must_hold(tick.t_s > last_s, "time rises");
    last_s = tick.t_s;
    recording.add(tick);
  });
  fuzz::must_hold(recording.finish() && bytes > 0, "a recording is written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const tools::RecordedRun run = parse_run(fuzz::as_text(data, size));
    record(run);
    fuzz::must_hold(!tools::to_plain_csv(run).empty(), "a table has a header");
    for (const auto pose : {tools::WhichPose::best, tools::WhichPose::model, tools::WhichPose::odometry,
                            tools::WhichPose::hybrid, tools::WhichPose::reference}) {
      try {
        tools::to_tum(run, {pose, ""});
      } catch (const tools::DataRefusal&) {  // no such pose
      }
    }
  } catch (const config::LogError&) {
  }
  return 0;
}
