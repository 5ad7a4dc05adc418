// wheelwright import: foreign data to a drive log.
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/drive_log_file.hpp"
#include "config/load/mrclam_files.hpp"
#include "config/load/text_format.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/commands.hpp"
#include "tools/wheelwright/json_text.hpp"
#include "tools/wheelwright/log_checks.hpp"

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

}  // namespace

Action add_import(CLI::App& app) {
  const auto files = std::make_shared<MrclamFiles>();
  CLI::App* command = app.add_subcommand("import", "Foreign data to a drive log");
  command->require_subcommand(1);
  command->footer(
      "Example: wheelwright import mrclam Robot1_Odometry.dat Robot1_Groundtruth.dat -o robot1.csv");
  add_mrclam(*command, files);
  return [files](Streams streams) { return import_mrclam(*files, streams); };
}

}  // namespace wheelwright::tools
