#include "tools/wheelwright/import/import_files.hpp"

#include <algorithm>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/conversion/clock_shift.hpp"
#include "tools/wheelwright/import/conversion/simulated_time.hpp"
#include "tools/wheelwright/import/files_of_folder.hpp"
#include "tools/wheelwright/import/inference/body_choice.hpp"
#include "tools/wheelwright/import/inference/metadata_roles.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"
#include "tools/wheelwright/import/open_recording.hpp"

namespace wheelwright::import {
namespace {

// Where several files have a table each, its stream is named as its file.
void name_tables(std::vector<Recording>& recordings) {
  if (recordings.size() < 2) return;
  for (auto& recording : recordings) {
    for (auto& stream : recording.streams) {
      if (stream.name.empty()) stream.name = std::filesystem::path(recording.name).stem().string();
    }
  }
}

// "left,right" of commands.csv and of encoders.csv are not the same.
bool mean_the_same(const Recording& a, const Stream& first, const Recording& b, const Stream& second) {
  const auto named_as_file = [](const Recording& recording, const Stream& stream) {
    Stream named;
    named.name = std::filesystem::path(recording.name).stem().string();
    named.type = stream.type;
    return named;
  };
  const Stream one = named_as_file(a, first);
  const Stream other = named_as_file(b, second);
  return std::ranges::all_of(first.channels, [&](const Channel& channel) {
    return meaning_of(one, channel).quantity == meaning_of(other, channel).quantity;
  });
}

bool have_the_same_columns(const Recording& a, const Recording& b) {
  if (a.streams.size() != 1 || b.streams.size() != 1) return false;
  const Stream& first = a.streams.front();
  const Stream& second = b.streams.front();
  return first.received_s.empty() && second.received_s.empty() &&
         std::ranges::equal(first.channels, second.channels, {}, &Channel::name, &Channel::name) &&
         mean_the_same(a, first, b, second);
}

// Tables of the same columns are runs of one robot: the rows of all, one after the other. Each begins a run.
void append_runs(std::vector<Recording>& recordings) {
  for (std::size_t i = 1; i < recordings.size();) {
    if (!have_the_same_columns(recordings.front(), recordings[i])) {
      ++i;
      continue;
    }
    Stream& all = recordings.front().streams.front();
    const Stream& next = recordings[i].streams.front();
    if (all.run_starts.empty()) all.run_starts.push_back(0);
    if (next.run_starts.empty()) all.run_starts.push_back(all.rows);
    for (const std::size_t start : next.run_starts) all.run_starts.push_back(all.rows + start);
    for (std::size_t c = 0; c < all.channels.size(); ++c) {
      auto& values = all.channels[c].values;
      values.insert(values.end(), next.channels[c].values.begin(), next.channels[c].values.end());
    }
    all.places.insert(all.places.end(), next.places.begin(), next.places.end());
    all.rows += next.rows;
    recordings.front().remarks.push_back("its rows are followed by those of " + recordings[i].name +
                                         ", a run of its own");
    recordings.erase(recordings.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::string names_of(const std::vector<std::filesystem::path>& files) {
  return files.size() == 1 ? files.front().string()
                           : files.front().string() + " and " + std::to_string(files.size() - 1) + " more";
}

std::optional<std::string> given_twice(const std::vector<ListedFile>& files) {
  for (auto file = files.begin(); file != files.end(); ++file) {
    std::error_code error;
    const auto same = std::find_if(files.begin(), file, [&](const ListedFile& other) {
      return std::filesystem::equivalent(other.path, file->path, error);
    });
    if (same == file) continue;
    return file->path.string() + ": is given twice" +
           (same->path == file->path ? std::string() : ", as " + same->path.string() + " too") +
           "; a run counts once";
  }
  return std::nullopt;
}

}  // namespace

tl::expected<Understood, std::string> understand(const ImportRequest& request) {
  Understood result;
  const auto files = files_of_folders(request.files);
  if (!files) return tl::unexpected(files.error());
  if (const auto twice = given_twice(*files)) return tl::unexpected(*twice);
  result.name = names_of(request.files);
  std::vector<std::string> left_out;
  for (const ListedFile& file : *files) {
    auto recording = open_recording(file.path);
    if (!recording && !file.is_given) {
      left_out.push_back("left out: " + recording.error());
      continue;
    }
    if (!recording) return tl::unexpected(recording.error());
    take_simulated_time(*recording);
    result.recordings.push_back(std::move(*recording));
  }
  if (result.recordings.empty()) return tl::unexpected(result.name + ": no file in it is a log");
  append_runs(result.recordings);
  if (request.reference) {
    auto recording = open_recording(*request.reference);
    if (!recording) return tl::unexpected(recording.error());
    stamp_frames(*recording);
    result.recordings.push_back(std::move(*recording));
  }
  name_tables(result.recordings);
  const auto chosen = choose_among_bodies(result.recordings, request.given);
  result.inference = infer_mapping(result.recordings, request.given);
  result.mapping = to_mapping(result.inference.entries, result.name);
  if (request.reference && !result.mapping.reference) {
    return tl::unexpected(
        request.reference->string() +
        ": no pose was found in it; say which columns hold it: --set reference.x=COLUMN, reference.y=COLUMN");
  }
  if (request.reference && result.mapping.reference && !request.given.says("reference.clock")) {
    result.mapping.reference->clock = ReferenceClock::shifted;
  }
  if (result.mapping.reference && result.mapping.reference->clock == ReferenceClock::shifted &&
      !result.mapping.reference->shift_s) {
    const auto shift = find_clock_shift(result.recordings, result.mapping);
    if (!shift) return tl::unexpected(result.name + ": " + shift.error());
    // What a reference shows is seen once its clock is that of the robot.
    GivenMapping shifted = request.given.with("reference.clock", "shifted")
                               .with("reference.shift_s", config::plain_number(shift->seconds));
    if (shift->rate != 1.0) shifted = shifted.with("reference.clock_rate", config::plain_number(shift->rate));
    result.inference = infer_mapping(result.recordings, shifted);
    result.mapping = to_mapping(result.inference.entries, result.name);
    result.inference.findings.push_back(shift->evidence);
  }
  result.inference.findings.insert(result.inference.findings.end(), left_out.begin(), left_out.end());
  if (chosen) result.inference.findings.push_back(*chosen);
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
