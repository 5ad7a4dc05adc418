// The configuration of the daemon: one YAML file, validated whole before anything moves.
//
// config/wheelwright.yaml is the file with every key, its default (but for run.route), its unit and its
// meaning.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "config/load/yaml_reader.hpp"
#include "drivers/roomba/link_config.hpp"
#include "model/brain/mission.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::config {

enum class CalibrateWhen : std::uint8_t { always, if_needed, never };

// What to do when real-time scheduling is not to be had.
enum class RealTimePolicy : std::uint8_t {
  require,  // do not start
  prefer,   // say so and go on
  off,      // do not ask
};

struct RealTimeConfig {
  RealTimePolicy policy = RealTimePolicy::prefer;
  int priority = 50;  // SCHED_FIFO, of the sensor loop
  bool lock_memory = true;
};

// Who may watch the robot, and stop it, through a browser.
struct LiveViewConfig {
  int port = 8765;                    // 0: off
  std::string address = "127.0.0.1";  // of the interface to listen at, IPv4 or IPv6
  std::string token;                  // what a caller has to show; empty only where nobody else can call
  std::filesystem::path truth;        // of a simulated robot, to be shown beside; empty: unknown
};

// When the gap workflow looks at the recorded drives for what the model lacks
// (daemon/model_watch/model_watch.hpp).
enum class GapWatch : std::uint8_t {
  off,
  when_due,   // after a drive in which the filter found that a calibration is due
  after_run,  // after each drive
};

enum class AtEnd : std::uint8_t {
  exit,  // the process ends with the run
  stay,  // it keeps the link and waits to be armed again
};

struct DaemonConfig {
  std::filesystem::path file;  // where this came from
  std::string robot_name = "roomba";
  std::filesystem::path device = "/dev/roomba";
  int baud = 115200;
  roomba::LinkConfig link;
  bool detect_encoder_order = true;
  RobotLimits limits;
  CalibrateWhen calibrate = CalibrateWhen::if_needed;
  ModelType calibration_type = ModelType::fir;  // of the model that a calibration makes
  EncoderTurnPlan encoder_turn;
  ResponsePlan response;  // without a repetition: left out
  RandomDrivePlan random_drive;
  bool adapt = true;                                // keep the model up to date while a route is driven
  std::filesystem::path model_file = "model.yaml";  // read where calibration is not needed, written by it
  std::optional<Route> route;                       // or
  std::optional<CommandedDrive> commanded_drive;    // none of both: only calibrate
  std::optional<double> largest_uncertainty_m;      // of a route by the model alone; more is refused
  PoseSource pose_source = PoseSource::fir;
  bool arm_at_start = true;
  AtEnd at_end = AtEnd::exit;
  GapWatch gap_watch = GapWatch::off;
  std::filesystem::path log_folder = "runs";
  bool mcap_log = false;  // an MCAP file beside the CSV logs
  RealTimeConfig real_time;
  LiveViewConfig live_view;
};

// Reads a configuration, its route included. File names in it are relative to its own folder, except those of
// what the daemon writes (model file, log folder), which are relative to the working directory. Throws
// ConfigError for anything that is not as it should be.
DaemonConfig load_daemon_config(const std::filesystem::path& path);

// The whole configuration as one file that needs no other: what a run keeps of itself, and what replay reads.
// Without live_view, which changes nothing in a run and holds a secret.
std::string daemon_config_to_yaml(const DaemonConfig& config);

}  // namespace wheelwright::config
