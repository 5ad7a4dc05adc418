// wheelwright replay: the daemon's brain over a recorded log.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "config/load/daemon_config.hpp"
#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_file.hpp"
#include "daemon/replay/replay.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

struct ReplayOptions {
  std::string log;
  std::string config;
  std::string model;
  std::string output;
  bool json = false;
};

// What a replay reads: a log, and the files that the daemon left beside it unless others are named.
struct ReplayFiles {
  fs::path log;
  fs::path config;
  fs::path model;
  fs::path pose_log;  // as it was recorded
};

ReplayFiles files_of(const ReplayOptions& options) {
  std::error_code ignored;
  const fs::path named = options.log;
  const bool is_folder = fs::is_directory(named, ignored);
  const fs::path folder = is_folder ? named : named.parent_path();
  if (is_folder && !fs::exists(folder / "drive_log.csv", ignored))
    throw UsageError(options.log + ": holds no drive_log.csv; name the folder of a run, or its drive log");
  return {is_folder ? folder / "drive_log.csv" : named,
          options.config.empty() ? folder / "config.yaml" : fs::path(options.config),
          options.model.empty() ? folder / "model.yaml" : fs::path(options.model), folder / "pose_log.csv"};
}

struct Comparison {
  std::size_t ticks = 0;
  std::optional<std::int64_t> first_difference;  // of the commands, as a tick
  std::optional<bool> same_pose_log;             // to the byte, where one was recorded
};

nlohmann::ordered_json to_json(const Comparison& comparison, const ReplayFiles& files,
                               const std::string& output) {
  nlohmann::ordered_json json{{"log", files.log.string()},
                              {"ticks", comparison.ticks},
                              {"first_different_command_tick", nullptr},
                              {"same_pose_log", nullptr},
                              {"output", nullptr}};
  if (comparison.first_difference) json["first_different_command_tick"] = *comparison.first_difference;
  if (comparison.same_pose_log) json["same_pose_log"] = *comparison.same_pose_log;
  if (!output.empty()) json["output"] = output;
  return json;
}

void print(std::ostream& out, const Comparison& comparison, const ReplayFiles& files,
           const std::string& output) {
  if (!output.empty()) out << "wrote " << output << "\n";
  out << comparison.ticks << " ticks replayed\n";
  if (!comparison.first_difference && comparison.same_pose_log.value_or(false))
    out << "the pose log is the same to the byte: " << files.pose_log.string() << "\n";
}

void refuse_difference(const Comparison& comparison, const ReplayFiles& files) {
  if (comparison.first_difference) {
    throw DataRefusal(
        files.log.string() + ": from tick " + std::to_string(*comparison.first_difference) +
        " on the brain commands something else than was recorded; is it of this configuration and model?");
  }
  if (!comparison.same_pose_log.value_or(true))
    throw DataRefusal(files.pose_log.string() + ": differs from the replay");
}

ExitStatus run_replay(const ReplayOptions& options, Streams streams) {
  const ReplayFiles files = files_of(options);
  check_output({options.output, config::OutputKind::pose_log},
               {files.log.string(), files.config.string(), files.model.string(), files.pose_log.string()});
  const auto config = config::load_daemon_config(files.config);
  std::optional<RobotModel> model;
  if (!options.model.empty() || fs::exists(files.model)) model = config::load_model(files.model);
  const auto result = daemon::replay(config::load_drive_log(files.log), config, model);
  if (!options.output.empty()) {
    if (const auto error =
            config::write_output({options.output, config::OutputKind::pose_log}, result.pose_log))
      throw UsageError(*error);
  }
  Comparison comparison{result.ticks, result.first_difference, std::nullopt};
  if (fs::exists(files.pose_log)) {
    const auto recorded = config::read_text_or_throw<UsageError>(files.pose_log, config::log_file);
    comparison.same_pose_log = recorded == result.pose_log;
  }
  if (options.json) {
    streams.out << json_text(to_json(comparison, files, options.output)) << "\n";
  } else {
    print(streams.out, comparison, files, options.output);
  }
  refuse_difference(comparison, files);
  return ExitStatus::done;
}

}  // namespace

Action add_replay(CLI::App& app) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "The daemon's brain over a recorded drive log");
  command->add_option("LOG", options->log, "Folder of a run, or the drive log that the daemon wrote in it")
      ->required();
  command->add_option("--config", options->config,
                      "Configuration of that run (default: config.yaml beside the log)");
  command->add_option("--model", options->model,
                      "Model that it started with (default: model.yaml beside the log)");
  command->add_option("-o,--output", options->output, "Pose log to write");
  command->add_flag("--json", options->json, "As JSON: ticks, and where the replay differs from the record");
  command->footer(
      "Exit status 1: the brain commands something else than was recorded, or the pose log differs.\n"
      "Example: wheelwright replay runs/2026-11-21T06-48-44Z");
  return [options](Streams streams) { return run_replay(*options, streams); };
}

}  // namespace wheelwright::tools
