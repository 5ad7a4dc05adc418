// The daemon's brain over a drive log in which anything may stand: ticks jump, clocks step, nothing is valid.
#include "daemon/replay/replay.hpp"

#include "config/load/drive_log_file.hpp"
#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

namespace {

config::DaemonConfig driving_by_odometry() {
  config::DaemonConfig config;
  config.calibrate = config::CalibrateWhen::never;
  config.pose_source = PoseSource::hybrid;
  config.route = Route{"fuzz", 0.15, 0.02, {{0.3, 0.0}, {0.0, 0.0}}};
  return config;
}

RobotModel simple_model() {
  RobotModel model;
  model.linear_part.left.from_left = {0.0, 0.4, 0.6};
  model.linear_part.left.from_right = {0.0, 0.0, 0.0};
  model.linear_part.right.from_left = {0.0, 0.0, 0.0};
  model.linear_part.right.from_right = {0.0, 0.4, 0.6};
  model.encoder_scale = EncoderScale{{0.000444565, 0.000444565}, 1660.0, 0.002};
  return model;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const config::DaemonConfig config = driving_by_odometry();
  static const RobotModel model = simple_model();
  try {
    const auto logs = config::parse_drive_logs(fuzz::as_text(data, size), "fuzz.csv");
    daemon::replay(logs.front(), config, model);
  } catch (const config::LogError&) {
  } catch (const config::ConfigError&) {
  }
  return 0;
}
