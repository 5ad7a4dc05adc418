#include "tools/wheelwright/import/import_files.hpp"

#include "tools/wheelwright/import/conversion/clock_shift.hpp"
#include "tools/wheelwright/import/open_recording.hpp"

namespace wheelwright::import {
namespace {

// Where several files have a table each, its stream is named as its file.
void name_tables(std::vector<Recording>& recordings, const std::vector<std::filesystem::path>& files) {
  if (recordings.size() < 2) return;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    for (auto& stream : recordings[i].streams) {
      if (stream.name.empty()) stream.name = files[i].stem().string();
    }
  }
}

std::string names_of(const std::vector<std::filesystem::path>& files) {
  return files.size() == 1 ? files.front().string()
                           : files.front().string() + " and " + std::to_string(files.size() - 1) + " more";
}

}  // namespace

tl::expected<Understood, std::string> understand(const ImportRequest& request) {
  Understood result;
  std::vector<std::filesystem::path> files = request.files;
  result.name = names_of(files);
  if (request.reference) files.push_back(*request.reference);
  for (const auto& file : files) {
    auto recording = open_recording(file);
    if (!recording) return tl::unexpected(recording.error());
    result.recordings.push_back(std::move(*recording));
  }
  name_tables(result.recordings, files);
  result.inference = infer_mapping(result.recordings, request.given);
  result.mapping = to_mapping(result.inference.entries, "mapping");
  if (request.reference && result.mapping.reference && !request.given.says("reference.clock")) {
    result.mapping.reference->clock = ReferenceClock::shifted;
  }
  if (result.mapping.reference && result.mapping.reference->clock == ReferenceClock::shifted &&
      !result.mapping.reference->shift_s) {
    const auto shift = find_clock_shift(result.recordings, result.mapping);
    if (!shift) return tl::unexpected(result.name + ": " + shift.error());
    result.mapping.reference->shift_s = shift->seconds;
    result.inference.findings.push_back(shift->evidence);
  }
  result.inference.entries = mapping_entries(result.mapping);
  return result;
}

tl::expected<Conversion, std::string> to_runs(const Understood& understood) {
  const auto columns = gather(understood.recordings, understood.mapping);
  if (!columns) return tl::unexpected(columns.error());
  auto conversion = convert(*columns, understood.mapping, understood.name);
  if (!conversion) return conversion;
  std::vector<std::string> remarks;
  for (const auto& recording : understood.recordings) {
    for (const auto& remark : recording.remarks) remarks.push_back(remark);
  }
  conversion->remarks.insert(conversion->remarks.begin(), remarks.begin(), remarks.end());
  return conversion;
}

}  // namespace wheelwright::import
