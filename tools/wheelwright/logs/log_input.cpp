#include "tools/wheelwright/logs/log_input.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <ostream>
#include <sstream>

#include "config/load/drive_log_file.hpp"
#include "model/log/headings_by_positions.hpp"
#include "model/log/sign_corrected_travel.hpp"
#include "tools/wheelwright/import/conversion/repair_checks.hpp"
#include "tools/wheelwright/import/import_files.hpp"
#include "tools/wheelwright/import/open_recording.hpp"
#include "tools/wheelwright/logs/free_memory.hpp"

namespace wheelwright::tools {
namespace {

constexpr double share_of_reading = 0.2;  // of what commands do with logs

bool is_sound(const std::vector<DriveLog>& runs) {
  return !import::find_repair(runs);
}

// How to read foreign files: what was said, and what all that have the same columns are taken for.
struct Reading {
  import::GivenMapping given;
  std::optional<import::Understood> together;
  std::vector<std::string> files_together = {};
};

// Nothing where they are fewer than two, or not all of the same columns, or cannot be understood.
Reading reading_of(const LogInput& input) {
  Reading reading{import::GivenMapping(input.import.mapping, input.import.settings), std::nullopt};
  std::vector<std::filesystem::path> foreign;
  for (const auto* paths : {&input.paths, &input.of_the_same_robot}) {
    std::ranges::remove_copy_if(*paths, std::back_inserter(foreign), import::is_drive_log);
  }
  if (foreign.size() < 2) return reading;
  std::ranges::sort(foreign);  // the same answer whichever of them are to be read
  try {
    auto all = import::understand({foreign, std::nullopt, reading.given});
    if (!all || all->recordings.size() != 1 || !import::to_runs(*all)) return reading;
    reading.together = *std::move(all);
    reading.files_together.assign(foreign.begin(), foreign.end());
  } catch (const std::runtime_error&) {
    // Whichever it was says so when it is read by itself.
  }
  return reading;
}

tl::expected<import::Understood, std::string> understood_by(const std::string& path, const Reading& reading) {
  if (std::ranges::find(reading.files_together, path) == reading.files_together.end())
    return import::understand({{path}, std::nullopt, reading.given});
  auto recording = import::open_recording(path);
  if (!recording) return tl::unexpected(recording.error());
  return import::Understood{
      path, {*std::move(recording)}, reading.together->inference, reading.together->mapping};
}

std::vector<DriveLog> import_runs(const std::string& path, const Reading& reading, std::ostream& err) {
  const auto understood = understood_by(path, reading);
  if (!understood) throw config::LogError(understood.error());
  auto conversion = import::to_runs(*understood);
  if (!conversion) throw config::LogError(conversion.error());
  std::string said = path + ": imported from " + understood->recordings.front().format;
  for (const auto& finding : understood->inference.findings) said += "; " + finding;
  err << "wheelwright: " << said << "\n";
  for (const auto& doubt : understood->inference.doubts)
    err << "wheelwright: " << path << ": " << doubt << "\n";
  for (const auto& remark : conversion->remarks) err << "wheelwright: " << path << ": " << remark << "\n";
  return std::move(conversion->runs);
}

// A drive log says most precisely itself what is wrong with it.
std::vector<DriveLog> load_runs(const std::string& path, const Reading& reading, std::ostream& err) {
  if (!reading.given.entries().empty()) return import_runs(path, reading, err);
  std::string refusal;
  try {
    auto runs = config::load_drive_logs(path);
    if (is_sound(runs)) return runs;
  } catch (const config::LogError& error) {
    refusal = error.what();
  }
  try {
    return import_runs(path, reading, err);
  } catch (const std::runtime_error& error) {
    if (refusal.empty() || !import::is_drive_log(path)) throw;
    throw config::LogError(refusal);
  }
}

void give_headings(std::vector<DriveLog>& runs, std::ostream& err) {
  for (DriveLog& run : runs) {
    if (!has_positions_alone(run)) continue;
    err << "wheelwright: " << run.name << ": ";
    if (const auto found = find_headings(run)) {
      const auto milliradians = std::lround(1e3 * found->heading_rad);
      err << "its positions have no headings; these were found from positions and counts, to " << milliradians
          << " mrad\n";
    } else {
      err << "its positions are not used: they have no headings, and "
          << (run.has_ticks() ? "the robot moves too little to find them"
                              : "without counts these cannot be found")
          << "\n";
    }
  }
}

}  // namespace

void add_import_options(CLI::App& command, ImportOptions& options) {
  command.add_option("--mapping", options.mapping, "Mapping file (YAML) for logs that are no drive logs");
  command.add_option("--set", options.settings, "Keys of the mapping, e.g. robot.wheel_base_m=0.235")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

std::vector<DriveLog> load_all_runs(const LogInput& input, std::ostream& err) {
  ProgressLine progress(err);
  return load_all_runs(input, err, progress);
}

std::vector<DriveLog> load_all_runs(const LogInput& input, std::ostream& err, ProgressLine& progress) {
  if (const auto missing = find_missing_memory(input.paths)) throw config::LogError(*missing);
  const auto say = progress.callback();
  say("reading " + (input.paths.empty() ? "" : input.paths.front()), 0.0);
  const Reading reading = reading_of(input);
  std::vector<DriveLog> runs;
  for (std::size_t i = 0; i < input.paths.size(); ++i) {
    const std::string& path = input.paths[i];
    say("reading " + path,
        share_of_reading * static_cast<double>(i) / static_cast<double>(input.paths.size()));
    std::ostringstream remarks;
    auto of_file = load_runs(path, reading, remarks);
    take_sign_corrected_travel(of_file);
    give_headings(of_file, remarks);
    if (!remarks.view().empty()) progress.clear();
    err << remarks.view();
    for (auto& run : of_file) runs.push_back(std::move(run));
  }
  return runs;
}

DriveLog load_one_run(const LogInput& input, std::ostream& err) {
  if (const auto missing = find_missing_memory(input.paths)) throw config::LogError(*missing);
  ProgressLine progress(err);
  progress.callback()("reading " + input.paths.front(), 0.0);
  std::ostringstream remarks;
  auto runs = load_runs(input.paths.front(), reading_of(input), remarks);
  progress.clear();
  err << remarks.view();
  if (runs.size() != 1) {
    throw config::LogError(input.paths.front() + ": holds " + std::to_string(runs.size()) +
                           " runs (the second starts in line " + std::to_string(runs[1].first_line) +
                           "), but one is wanted here; split the file");
  }
  return std::move(runs.front());
}

std::vector<DriveLog> with_wheel_on_both_sides(std::vector<DriveLog> runs) {
  const std::size_t count = runs.size();
  for (std::size_t run = 0; run < count; ++run) {
    const auto& metadata = runs[run].other_metadata;
    if (std::ranges::find(metadata, "one_wheel", &std::pair<std::string, std::string>::first) ==
        metadata.end())
      continue;
    DriveLog mirrored = runs[run];
    for (auto& sample : mirrored.samples) {
      std::swap(sample.command_m_s.left, sample.command_m_s.right);
      if (sample.ticks) std::swap(sample.ticks->left, sample.ticks->right);
    }
    runs.push_back(std::move(mirrored));
  }
  return runs;
}

}  // namespace wheelwright::tools
