// wheelwright replay: the daemon's brain over a recorded log.
#include <filesystem>
#include <optional>
#include <ostream>

#include "config/load/atomic_file.hpp"
#include "config/load/daemon_config.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/text_file.hpp"
#include "daemon/replay.hpp"
#include "tools/wheelwright/commands.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct ReplayOptions {
  std::string log;
  std::string config;
  std::string model;
  std::string output;
};

// The files that the daemon left beside its log, unless others are named.
fs::path beside(const std::string& log, const std::string& named, const char* usual) {
  return named.empty() ? fs::path(log).parent_path() / usual : fs::path(named);
}

ExitStatus run_replay(const ReplayOptions& options, Streams streams) {
  const auto config = config::load_daemon_config(beside(options.log, options.config, "config.yaml"));
  const fs::path model_file = beside(options.log, options.model, "model.yaml");
  std::optional<RobotModel> model;
  if (!options.model.empty() || fs::exists(model_file)) model = config::load_model(model_file);
  const auto result = daemon::replay(config::load_drive_log(options.log), config, model);

  if (!options.output.empty()) {
    if (const auto error = config::write_file_atomically(options.output, result.pose_log))
      throw UsageError(*error);
    streams.out << "wrote " << options.output << "\n";
  }
  streams.out << result.ticks << " ticks replayed\n";
  if (result.first_difference) {
    throw DataRefusal(
        options.log + ": from tick " + std::to_string(*result.first_difference) +
        " on the brain commands something else than was recorded; is it of this configuration and model?");
  }
  const fs::path recorded = fs::path(options.log).parent_path() / "pose_log.csv";
  const auto recorded_text = config::read_text(recorded);
  if (!recorded_text) return ExitStatus::done;
  if (*recorded_text != result.pose_log) throw DataRefusal(recorded.string() + ": differs from the replay");
  streams.out << "the pose log is the same to the byte: " << recorded.string() << "\n";
  return ExitStatus::done;
}

}  // namespace

Action add_replay(CLI::App& app) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "The daemon's brain over a recorded drive log");
  command->add_option("LOG", options->log, "Drive log that the daemon wrote")->required();
  command->add_option("--config", options->config,
                      "Configuration of that run (default: config.yaml beside the log)");
  command->add_option("--model", options->model,
                      "Model that it started with (default: model.yaml beside the log)");
  command->add_option("-o,--output", options->output, "Pose log to write");
  command->footer("Example: wheelwright replay runs/2026-11-21T06-48-44Z/drive_log.csv");
  return [options](Streams streams) { return run_replay(*options, streams); };
}

}  // namespace wheelwright::tools
