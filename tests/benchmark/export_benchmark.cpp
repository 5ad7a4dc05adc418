// A run of 15 minutes, logged each 18 ms, from its CSV logs to an MCAP file in memory.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/export/recorded_run.hpp"

namespace {

using namespace wheelwright;
namespace fs = std::filesystem;

constexpr int ticks = 50'000;

std::string fields(int count, double start) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "," + config::fixed_number(std::sin(start + i), 6);
  return text;
}

// With the columns of the daemon's logs, and numbers of their length.
fs::path quarter_of_an_hour() {
  const fs::path folder = fs::temp_directory_path() / "wheelwright_export_benchmark";
  fs::create_directories(folder);
  std::ofstream drive(folder / "drive_log.csv");
  std::ofstream pose(folder / "pose_log.csv");
  drive << "# wheelwright_drive_log: "
           "1\nt,cmd_left,cmd_right,battery_v,current_left_a,current_right_a,light_left,"
           "light_front_left,light_center_left,light_center_right,light_front_right,light_right,bump,wheel_"
           "drop,"
           "cliff,overcurrents,ticks_left,ticks_right,activity,stop\n";
  pose << "# wheelwright_pose_log: 1\n# pose_source: fir\nt,speed_left,speed_right,v,w,x,y,theta,odometry_x,"
          "odometry_y,odometry_theta,measured_speed_left,measured_speed_right,hybrid_x,hybrid_y,hybrid_theta,"
          "hybrid_cov_xx,hybrid_cov_xy,hybrid_cov_yy,hybrid_cov_xtheta,hybrid_cov_ytheta,hybrid_cov_"
          "thetatheta,"
          "activity,events\n";
  for (int k = 0; k < ticks; ++k) {
    const std::string t = config::fixed_number(0.018 * k, 6);
    drive << t << fields(11, k) << ",0,0,0,0," << 7 * k << "," << 7 * k << ",route,none\n";
    pose << t << fields(21, k) << ",route,\n";
  }
  return folder;
}

void export_of_15_minutes_to_mcap(benchmark::State& state) {
  const fs::path folder = quarter_of_an_hour();
  std::size_t bytes = 0;
  for ([[maybe_unused]] const auto& iteration : state) {
    bytes = 0;
    const auto run = tools::load_recorded_run(folder.string());
    mcap::RobotRecording recording(
        [&bytes](std::string_view more) {
          bytes += more.size();
          return true;
        },
        {}, mcap::SteeringPose::model);
    tools::for_each_tick(run, [&recording](const mcap::TickValues& tick) { recording.add(tick); });
    recording.finish();
  }
  state.counters["file_MB"] = 1e-6 * static_cast<double>(bytes);
  fs::remove_all(folder);
}
BENCHMARK(export_of_15_minutes_to_mcap)->Unit(benchmark::kMillisecond);

}  // namespace
