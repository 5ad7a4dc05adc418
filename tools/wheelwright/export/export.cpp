// wheelwright export: a run, or a model, to what other tools read.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/output_file.hpp"
#include "daemon/recording/mcap/robot_recording.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/export/model_export.hpp"
#include "tools/wheelwright/export/plain_csv.hpp"
#include "tools/wheelwright/export/recorded_run.hpp"
#include "tools/wheelwright/export/tum.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"

namespace wheelwright::tools {
namespace {

struct ExportOptions {
  std::string log;
  std::string tum;
  std::string mcap;
  std::string csv;
  TumChoice choice;
  ModelExport model;
  bool json = false;
};

std::string to_mcap(const RecordedRun& run) {
  std::string file;
  const mcap::Sink sink = [&file](std::string_view bytes) {
    file += bytes;
    return true;
  };
  const auto metadata = metadata_of(run);
  const auto source = metadata.find("pose_source");
  mcap::RobotRecording recording(sink, metadata,
                                 mcap::steering_pose(source == metadata.end() ? "" : source->second));
  for_each_tick(run, [&recording](const mcap::TickValues& tick) { recording.add(tick); });
  recording.finish();
  return file;
}

// All of them, before the first is written.
void check_all(std::vector<config::OutputFile> outputs, const RecordedRun& run) {
  std::erase_if(outputs, [](const config::OutputFile& output) { return output.path.empty(); });
  config::InputFiles inputs;
  for (const auto* table : {&run.drive, &run.poses}) {
    if (*table) inputs.emplace_back((*table)->name());
  }
  if (const auto problem = config::check_outputs(outputs, inputs)) throw UsageError(*problem);
}

ExitStatus run_export(const ExportOptions& options, Streams streams) {
  const bool of_run = !options.tum.empty() || !options.mcap.empty() || !options.csv.empty();
  if (options.model.is_asked_for()) {
    if (of_run)
      throw UsageError("--to takes a model, and --mcap, --tum and --csv a run; give one or the other");
    return export_model(options.log, options.model, options.json, streams);
  }
  if (!of_run)
    throw UsageError("nothing to write; add --mcap OUT, --tum OUT or --csv OUT, or --to for a model");
  const RecordedRun run = load_recorded_run(options.log);
  const config::OutputFile mcap{options.mcap, config::OutputKind::mcap};
  const config::OutputFile tum{options.tum, config::OutputKind::trajectory};
  const config::OutputFile csv{options.csv, config::OutputKind::plain_csv};
  check_all({mcap, tum, csv}, run);
  auto written = nlohmann::ordered_json::array();
  const auto write = [&](const char* format, const config::OutputFile& file, const std::string& bytes) {
    tools::write(file, bytes);
    written.push_back({{"format", format}, {"file", file.path.string()}, {"bytes", bytes.size()}});
    if (!options.json) streams.out << "wrote " << file.path.string() << "\n";
  };
  if (!options.mcap.empty()) write("mcap", mcap, to_mcap(run));
  if (!options.tum.empty()) write("tum", tum, to_tum(run, options.choice));
  if (!options.csv.empty()) write("csv", csv, to_plain_csv(run));
  if (options.json) streams.out << json_text(nlohmann::ordered_json{{"wrote", written}}) << "\n";
  return ExitStatus::done;
}

}  // namespace

Action add_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "A run or a model to what other tools read");
  command
      ->add_option("LOG", options->log,
                   "Folder of a run, or a drive log, or a pose log; with --to, a model file")
      ->required();
  command->add_option("--mcap", options->mcap, "MCAP file to write, for Foxglove, Lichtblick, PlotJuggler");
  command->add_option("--tum", options->tum, "Trajectory to write, for evo: timestamp x y z qx qy qz qw");
  command->add_option("--csv", options->csv, "CSV to write, for pandas and PlotJuggler: header row first");
  command
      ->add_option("--pose", options->choice.pose,
                   "With --tum; best is reference if there is one, else what steers")
      ->transform(one_of<WhichPose>({{"best", WhichPose::best},
                                     {"model", WhichPose::model},
                                     {"odometry", WhichPose::odometry},
                                     {"hybrid", WhichPose::hybrid},
                                     {"reference", WhichPose::reference}}))
      ->default_str("best");
  command->add_option("--during", options->choice.during,
                      "With --tum: only of this activity, as 'route'; poses start at zero there");
  add_model_options(*command, options->model);
  command->add_flag("--json", options->json, "The files that were written, as JSON");
  command->footer(
      "Example: wheelwright export runs/2026-11-21T06-48-44Z --mcap run.mcap\n"
      "         wheelwright export robot.yaml --to c -o robot.h\n"
      "         wheelwright export robot.yaml --to sdf --wheel-radius 0.036 --patch robot.sdf");
  return [options](Streams streams) { return run_export(*options, streams); };
}

}  // namespace wheelwright::tools
