#include "tools/wheelwright/report/run_material.hpp"

#include <algorithm>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/text_file.hpp"
#include "daemon/replay/recorded_frames.hpp"
#include "tools/wheelwright/export/recorded_run.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

// A log that the daemon wrote tells what the robot was doing.
bool is_of_the_daemon(const config::CsvTable& drive) {
  return drive.has("travel_ticks_left");
}

// As the daemon does, but for models that are adapted while driving, which it keeps as files.
CalibrationMaterial calibrate_again(const DriveLog& log, const config::DaemonConfig& config) {
  CalibrationMaterial material;
  auto mission = Mission{};
  mission.encoder_turn = config.encoder_turn;
  mission.response = config.response;
  mission.random_drive = config.random_drive;
  Calibrator calibrator(mission, config.limits, std::nullopt);
  const daemon::RecordedFrames frames(log);
  for (std::size_t row = 0; row < frames.size(); ++row) {
    auto outcome = calibrator.take(frames.frame_with_command(row));
    if (!outcome) continue;
    if (outcome->refusal) material.refusals.push_back(outcome->refusal->reason);
    if (outcome->encoder_scale) material.scale = std::move(outcome->encoder_scale);
    if (outcome->response) material.fir = std::move(outcome->response);
    if (outcome->arma) material.arma = std::move(outcome->arma);
    if (outcome->model) material.model = std::move(outcome->model);
  }
  material.turn = calibrator.turn_samples();
  material.responses = calibrator.response_runs();
  material.random = calibrator.random_run();
  return material;
}

// Where the run's own configuration is not there: what the log says of its robot, the rest as usual.
config::DaemonConfig default_config(const DriveLog& log) {
  config::DaemonConfig config;
  config.limits.wheel_base_m = log.wheel_base_m;
  config.limits.period_s = log.period_s;
  config.encoder_turn.options.wheel_base_m = log.wheel_base_m;
  if (log.metres_per_tick) config.limits.metres_per_tick = *log.metres_per_tick;
  return config;
}

void read_neighbours(const fs::path& folder, RunMaterial& material) {
  std::error_code ignored;
  if (fs::exists(folder / "config.yaml", ignored)) {
    material.config = config::load_daemon_config(folder / "config.yaml");
  }
  if (fs::exists(folder / "model.yaml", ignored)) material.model = config::load_model(folder / "model.yaml");
  const fs::path lateness = folder / daemon::lateness_file_name;
  if (fs::exists(lateness, ignored)) {
    const auto text = config::read_text_or_throw<config::LogError>(lateness, config::record_file);
    material.lateness = daemon::parse_lateness(text, lateness.string());
  }
}

}  // namespace

RunMaterial load_run_material(const fs::path& path, const std::optional<RobotModel>& model) {
  RunMaterial material;
  material.name = (path.has_filename() ? path : path.parent_path()).filename().string();
  // Gone before the log is read as a log: of hours, both do not fit into a gigabyte.
  auto run = std::make_unique<const RecordedRun>(load_recorded_run(path.string()));
  material.metadata = metadata_of(*run);
  const bool of_the_daemon = run->drive && is_of_the_daemon(*run->drive);
  if (of_the_daemon || run->poses)
    for_each_tick(*run, [&](const mcap::TickValues& tick) { material.ticks.push_back(tick); });
  const auto drive_path = run->drive ? std::optional(run->drive->name()) : std::nullopt;
  run.reset();
  if (drive_path) material.drive = config::load_drive_log(*drive_path);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) read_neighbours(path, material);
  if (material.drive && of_the_daemon) {
    material.calibration = calibrate_again(
        *material.drive, material.config ? *material.config : default_config(*material.drive));
  }
  if (material.calibration.model) material.model = material.calibration.model;
  if (model) material.model = model;
  return material;
}

}  // namespace wheelwright::tools
