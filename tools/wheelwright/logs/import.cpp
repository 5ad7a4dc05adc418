// wheelwright import: foreign data to a drive log.
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/mrclam_files.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/import/import_files.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {
namespace {

struct MrclamFiles {
  std::string odometry;
  std::string ground_truth;
  std::string output;
  config::MrclamOptions options;
  bool json = false;
};

double length_s(const config::MrclamRun& run) {
  return run.log.samples.back().t_s - run.log.samples.front().t_s;
}

void print(std::ostream& out, const config::MrclamRun& run, const std::string& output) {
  out << run.log.samples.size() << " rows, " << config::fixed_number(length_s(run), 1)
      << " s: " << run.commands << " commands, " << run.references
      << " reference poses\nleft out: " << run.references_before << " poses before the first command and "
      << run.references_after << " after the last, " << run.superseded
      << " commands at whose very time another follows\nwrote " << output << "\n";
}

nlohmann::ordered_json to_json(const config::MrclamRun& run, const std::string& output) {
  return {{"rows", run.log.samples.size()},
          {"duration_s", length_s(run)},
          {"commands", run.commands},
          {"reference_poses", run.references},
          {"left_out",
           {{"poses_before_first_command", run.references_before},
            {"poses_after_last_command", run.references_after},
            {"superseded_commands", run.superseded}}},
          {"output", output}};
}

ExitStatus import_mrclam(const MrclamFiles& files, Streams streams) {
  check_output({files.output, config::OutputKind::drive_log}, {files.odometry, files.ground_truth});
  const auto run = config::load_mrclam_run(files.odometry, files.ground_truth, files.options);
  config::save_drive_log(run.log, files.output);
  if (files.json) {
    streams.out << json_text(to_json(run, files.output)) << "\n";
  } else {
    print(streams.out, run, files.output);
  }
  return ExitStatus::done;
}

void add_mrclam(CLI::App& import, const std::shared_ptr<MrclamFiles>& files) {
  CLI::App* mrclam = import.add_subcommand("mrclam", "A run of the UTIAS MRCLAM data set (iRobot Create)");
  mrclam->add_option("ODOMETRY", files->odometry, "RobotN_Odometry.dat: time, forward and angular speed")
      ->required();
  mrclam->add_option("GROUNDTRUTH", files->ground_truth, "RobotN_Groundtruth.dat: time, x, y, orientation")
      ->required();
  mrclam->add_option("-o,--output", files->output, "Drive log to write")->required();
  mrclam->add_option("--wheel-base", files->options.wheel_base_m, "Distance between the wheels [m]")
      ->check(number_between(0.01, 10.0, "m"))
      ->capture_default_str();
  mrclam
      ->add_option("--period", files->options.period_s,
                   "Period that the log states for a model [s]; rows stay at their own times")
      ->check(number_between(0.001, 10.0, "s"))
      ->capture_default_str();
  mrclam->add_flag("--json", files->json, "What was joined and what was left out, as JSON");
  mrclam->footer(
      "Example: wheelwright import mrclam Robot1_Odometry.dat Robot1_Groundtruth.dat -o robot1.csv");
}

struct ImportCommand {
  std::vector<std::string> files;
  std::string reference;
  ImportOptions import;
  std::string output;
  bool json = false;
};

// One file, or a file for each run where the output is a folder.
std::vector<std::string> outputs_for(const std::string& output, std::size_t runs) {
  std::error_code ignored;
  if (!output.ends_with('/') && !std::filesystem::is_directory(output, ignored)) return {output};
  std::vector<std::string> paths;
  for (std::size_t run = 1; run <= runs; ++run) {
    paths.push_back((std::filesystem::path(output) / ("run_" + std::to_string(run) + ".csv")).string());
  }
  return paths;
}

void check_all_outputs(const ImportCommand& options, const std::vector<std::string>& outputs) {
  std::vector<std::string> inputs = options.files;
  inputs.insert(inputs.end(), {options.reference, options.import.mapping});
  for (const auto& output : outputs) check_output({output, config::OutputKind::drive_log}, inputs);
}

void save_runs(const std::vector<DriveLog>& runs, const ImportCommand& options) {
  const auto outputs = outputs_for(options.output, runs.size());
  if (outputs.size() == 1 && outputs.front() == options.output)
    return config::save_drive_logs(runs, options.output);
  make_folder(options.output);
  check_all_outputs(options, outputs);
  for (std::size_t run = 0; run < runs.size(); ++run) config::save_drive_log(runs[run], outputs[run]);
}

void print(std::ostream& out, const ImportCommand& options, const import::Understood& understood,
           const import::Conversion& conversion) {
  for (const auto& recording : understood.recordings)
    out << config::printable(recording.name) << ": " << config::printable(recording.format) << "\n";
  for (const auto& finding : understood.inference.findings)
    out << "found: " << config::printable(finding) << "\n";
  for (const auto& doubt : understood.inference.doubts) out << "doubt: " << config::printable(doubt) << "\n";
  for (const auto& remark : conversion.remarks) out << "note: " << config::printable(remark) << "\n";
  for (const auto& line : describe_contradictions(conversion.runs))
    out << "doubt: " << config::printable(line) << "\n";
  for (const auto& run : conversion.runs) {
    out << run.samples.size() << " rows, " << config::fixed_number(run.samples.back().t_s, 1) << " s, "
        << config::plain_number(run.period_s) << " s apart\n";
  }
  out << "wrote " << config::printable(options.output) << "\n";
}

nlohmann::ordered_json to_json(const ImportCommand& options, const import::Understood& understood,
                               const import::Conversion& conversion) {
  nlohmann::ordered_json json{{"formats", nlohmann::ordered_json::array()}};
  for (const auto& recording : understood.recordings) json["formats"].push_back(recording.format);
  json["found"] = understood.inference.findings;
  json["doubts"] = understood.inference.doubts;
  json["notes"] = conversion.remarks;
  for (const auto& entry : understood.inference.entries) json["mapping"][entry.key] = entry.value;
  for (const auto& line : describe_contradictions(conversion.runs)) json["doubts"].push_back(line);
  for (const auto& run : conversion.runs) {
    json["runs"].push_back(
        {{"rows", run.samples.size()}, {"duration_s", run.samples.back().t_s}, {"period_s", run.period_s}});
  }
  json["output"] = options.output;
  return json;
}

ExitStatus import_files(const ImportCommand& options, Streams streams) {
  if (options.files.empty())
    throw UsageError("name the files to import; 'wheelwright import --help' has an example");
  if (options.output.empty()) throw UsageError("say where the drive log is to go: -o LOG.csv");
  if (outputs_for(options.output, 1).front() == options.output) check_all_outputs(options, {options.output});
  import::ImportRequest request{{options.files.begin(), options.files.end()},
                                std::nullopt,
                                { options.import.mapping,
                                  options.import.settings }};
  if (!options.reference.empty()) request.reference = options.reference;
  const auto understood = import::understand(request);
  if (!understood) throw UsageError(understood.error());
  const auto conversion = import::to_runs(*understood);
  if (!conversion) throw DataRefusal(conversion.error());
  save_runs(conversion->runs, options);
  if (options.json) {
    streams.out << json_text(to_json(options, *understood, *conversion)) << "\n";
  } else {
    print(streams.out, options, *understood, *conversion);
  }
  return ExitStatus::done;
}

}  // namespace

Action add_import(CLI::App& app) {
  const auto files = std::make_shared<MrclamFiles>();
  const auto options = std::make_shared<ImportCommand>();
  CLI::App* command = app.add_subcommand("import", "Any robot's log to a drive log");
  command->require_subcommand(0, 1);
  command->add_option("FILE", options->files,
                      "CSV and other text, ROS 1 and ROS 2 bags, MATLAB files, WPILOG; several make one run, "
                      "tables of the same columns a run each");
  command->add_option("-o,--output", options->output,
                      "Drive log to write; a folder gets a file for each run");
  command->add_option("--reference", options->reference,
                      "File of poses from outside, with a clock of its own");
  add_import_options(*command, options->import);
  command->add_flag("--json", options->json, "What was found and done, as JSON");
  command->footer(
      "What is not said is found: 'wheelwright inspect FILE' shows it. The mapping that was used is in the "
      "log's header.\n"
      "Exit status: 0 a log was written, 1 something has to be given (it says what), 2 bad usage or no "
      "readable file.\n"
      "Example: wheelwright import drive.bag --set robot.wheel_base_m=0.287 -o drive.csv");
  add_mrclam(*command, files);
  return [files, options, command](Streams streams) {
    return command->get_subcommands().empty() ? import_files(*options, streams)
                                              : import_mrclam(*files, streams);
  };
}

}  // namespace wheelwright::tools
