// wheelwright gap: finds where a simulation and measured runs disagree, names what is missing, adds it, and
// shows the gap shrink.
#include <filesystem>
#include <memory>
#include <ostream>

#include "config/load/atomic_file.hpp"
#include "config/load/model_file.hpp"
#include "model/gap/gap_analysis.hpp"
#include "tools/wheelwright/commands.hpp"
#include "tools/wheelwright/gap/gap_json.hpp"
#include "tools/wheelwright/gap/gap_text.hpp"
#include "tools/wheelwright/gap/progress_line.hpp"
#include "tools/wheelwright/gap/side_by_side.hpp"
#include "tools/wheelwright/log_checks.hpp"
#include "tools/wheelwright/now.hpp"

namespace wheelwright::tools {
namespace {

struct GapCommand {
  std::vector<std::string> train;
  std::vector<std::string> test;
  std::string model;
  std::string output;
};

void write(const std::filesystem::path& path, const std::string& text) {
  if (const auto error = config::write_file_atomically(path, text)) throw UsageError(*error);
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    throw UsageError(path +
                     ": cannot be made: " + (error ? error.message() : "a file of that name is there"));
  }
}

ExitStatus run_gap(const GapCommand& command, Streams streams) {
  gap::GapOptions options;
  if (!command.model.empty()) options.model = config::load_model(command.model);
  const auto train = load_all_runs(command.train);
  const auto test = command.test.empty() ? std::vector<DriveLog>{} : load_all_runs(command.test);
  make_folder(command.output);

  const ProgressLine progress(streams.err);
  auto analysis = gap::analyse_gap(train, test, options, side_by_side(), progress.callback());
  progress.clear();
  if (!analysis) throw UsageError(analysis.error().reason);
  analysis->after.created = now_as_text();
  analysis->after.robot = robot_name(train.front());
  for (auto& effect : analysis->after.effects) effect.created = analysis->after.created;

  const std::filesystem::path folder = command.output;
  write(folder / "gap.json", gap_to_json(*analysis));
  if (!analysis->after.core.left.from_left.empty())
    config::save_model(analysis->after, folder / "model.yaml");
  print_gap(streams.out, *analysis);
  streams.out << "\nwrote " << (folder / "gap.json").string() << "\n";
  return ExitStatus::done;
}

}  // namespace

Action add_gap(CLI::App& app) {
  const auto options = std::make_shared<GapCommand>();
  CLI::App* command =
      app.add_subcommand("gap", "What effect the simulation of a robot lacks, and how sure that is");
  command->add_option("--train", options->train, "Drive logs to find it in")->required();
  command->add_option("--test", options->test,
                      "Drive logs to confirm it on; else some of the others are held out");
  command->add_option("--model", options->model,
                      "Model whose gap is looked for; else a linear one is fitted");
  command->add_option("-o,--output", options->output, "Folder for gap.json, model.yaml and report.html")
      ->required();
  command->footer("Example: wheelwright gap --train run1.csv run2.csv run3.csv --test run4.csv -o gap");
  return [options](Streams streams) { return run_gap(*options, streams); };
}

}  // namespace wheelwright::tools
