#include "tools/wheelwright/export/patch/write_patch.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/output_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/export/patch/text_edits.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;

constexpr config::FileKind described_robot{"the description of a robot", 8U << 20U};

PatchedFile load(const std::string& path) {
  PatchedFile file{path, config::read_text_or_throw<UsageError>(path, described_robot)};
  if (!is_plain_utf8(file.text)) {
    throw UsageError(path + ": is not UTF-8; convert it first, as by iconv -f LATIN1 -t UTF-8");
  }
  return file;
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() != fs::file_type::not_found;
}

// FILE.bak, or the first of FILE.bak2, FILE.bak3 that is free.
std::string write_backup(const PatchedFile& file) {
  constexpr int most = 10'000;
  std::string path = file.name + ".bak";
  for (int number = 2; is_there(path) && number <= most; ++number)
    path = file.name + ".bak" + std::to_string(number);
  if (is_there(path))
    throw UsageError(path + ": is there already, and no name before it is free; remove some");
  write(path, file.text);
  return path;
}

std::string status_of(const NumberChange& change) {
  if (change.is_unsaid()) return "unsaid";
  if (!change.before) return "added";
  if (*change.before != change.after) return "changed";
  return change.kept_within.empty() ? "already_so" : "kept";
}

std::string sentence(const NumberChange& change) {
  const std::string place = config::printable(change.place);
  if (change.is_unsaid()) return place + ": " + change.after + " cannot be said here: " + change.reason;
  if (!change.before) return place + ": added " + change.after;
  const std::string kept =
      change.kept_within.empty() ? "" : "; tighter than the robot's own " + change.kept_within;
  const std::string after = config::excerpt(change.after);
  if (*change.before != change.after)
    return place + ": changed from " + config::excerpt(*change.before) + " to " + after + kept;
  return place + (kept.empty() ? ": already " : ": kept at ") + after + kept;
}

void print(std::ostream& out, const PatchedFile& file, const Patch& patch) {
  for (const NumberChange& change : patch.changes) {
    out << file.name;
    if (change.row > 0) out << ":" << change.row;
    out << ": " << sentence(change) << "\n";
  }
  for (const auto& [effect, reason] : patch.unsaid)
    out << effect << " cannot be said in this format: " << reason << "\n";
}

nlohmann::ordered_json to_json(const NumberChange& change) {
  nlohmann::ordered_json json{{"place", change.place}, {"status", status_of(change)}};
  if (change.row > 0) json["row"] = change.row;
  if (change.before) json["before"] = *change.before;
  json["after"] = change.after;
  if (!change.kept_within.empty()) json["kept_within"] = change.kept_within;
  if (change.number.figures.size() == 1 && change.number.figures.front().interval) {
    const auto& interval = *change.number.figures.front().interval;
    json["ci95"] = {interval.lower, interval.upper};
  }
  if (!change.number.unit.empty()) json["unit"] = change.number.unit;
  if (!change.number.remark.empty()) json["remark"] = change.number.remark;
  if (change.is_unsaid()) json["reason"] = change.reason;
  return json;
}

nlohmann::ordered_json to_json(const Patch& patch) {
  auto numbers = nlohmann::ordered_json::array();
  for (const NumberChange& change : patch.changes) numbers.push_back(to_json(change));
  auto unsaid = nlohmann::ordered_json::array();
  for (const auto& [effect, reason] : patch.unsaid)
    unsaid.push_back({{"effect", effect}, {"reason", reason}});
  return {{"numbers", numbers}, {"unsaid", unsaid}};
}

// What a patch has made must be what it would make again.
void check(const PatchedFile& file, const Patch& patch,
           const std::function<Patch(const PatchedFile&)>& patch_again) {
  std::string problem;
  try {
    if (patch_again({file.name, patch.text}).text == patch.text) return;
  } catch (const UsageError& error) {
    problem = std::string(" (") + error.what() + ")";
  }
  throw UsageError(file.name + ": is laid out in a way in which its numbers cannot be changed alone" +
                   problem + "; nothing was written; put each number in a line of its own");
}

}  // namespace

void check_patch_output(const PatchPaths& paths) {
  const bool in_place = paths.output.empty();
  config::InputFiles inputs{paths.model};
  if (!in_place) inputs.emplace_back(paths.file);
  const std::vector<config::OutputFile> outputs{
      {in_place ? paths.file : paths.output, config::OutputKind::any}};
  if (!in_place && is_there(paths.output)) {
    const auto there = config::read_text(paths.output, described_robot);
    if (there && !there->empty()) {
      throw UsageError(paths.output +
                       ": is there already, and is not replaced; remove it or give another name");
    }
  }
  if (const auto problem = config::check_outputs(outputs, inputs)) throw UsageError(*problem);
}

ExitStatus write_patch(const PatchPaths& paths, const std::function<Patch(const PatchedFile&)>& patch,
                       bool json, Streams streams) {
  const PatchedFile file = load(paths.file);
  const Patch patched = patch(file);
  check(file, patched, patch);
  const bool in_place = paths.output.empty();
  const bool changed = patched.text != file.text;
  const std::string target = in_place ? file.name : paths.output;
  std::string backup;
  if (changed && in_place) backup = write_backup(file);
  if (changed || !in_place) {
    write(target, patched.text);
  }
  if (json) {
    nlohmann::ordered_json result{{"file", target}, {"changed", changed}};
    if (!backup.empty()) result["backup"] = backup;
    result.update(to_json(patched));
    streams.out << json_text(result) << "\n";
    return ExitStatus::done;
  }
  print(streams.out, file, patched);
  if (!changed) streams.out << file.name << ": nothing to change\n";
  if (changed || !in_place) streams.out << "wrote " << target << "\n";
  if (!backup.empty()) streams.out << "wrote " << backup << ", as the file was\n";
  return ExitStatus::done;
}

}  // namespace wheelwright::tools
