#include "tools/wheelwright/import/formats/matlab/mat_file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/formats/matlab/mat_variable.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_columns = 512;
constexpr std::size_t short_vector = 8;  // values that go to the metadata where nothing else is so short

bool is_level5(std::string_view head) {
  return head.size() >= header_bytes && (head.substr(126, 2) == "IM" || head.substr(126, 2) == "MI") &&
         head.starts_with("MATLAB");
}

bool is_hdf5(std::string_view head) {
  return head.starts_with("MATLAB 7.3") || head.starts_with("\x89HDF\r\n\x1a\n");
}

std::string header_text(std::string_view bytes) {
  const std::string_view text = bytes.substr(0, 116);
  const auto end = text.find_last_not_of(std::string_view(" \0", 2));
  return std::string(text.substr(0, end == std::string_view::npos ? 0 : end + 1));
}

class Sorter {
 public:
  explicit Sorter(Recording& recording) : recording_(recording) {}

  void take(MatVariable variable) {
    if (variable.rows == 1 && variable.columns == 1) {
      recording_.metadata.emplace_back(variable.name, config::plain_number(variable.values.front()));
      return;
    }
    const bool is_vector = variable.rows == 1 || variable.columns == 1;
    if (is_vector) {
      const std::size_t length = std::max(variable.rows, variable.columns);
      stream_for(length).channels.push_back({variable.name, {}, std::move(variable.values)});
      return;
    }
    take_matrix(variable);
  }

  // A few values beside streams of many are parameters: wheel_base = [0.23 0.24].
  void finish() {
    std::size_t longest = 0;
    for (const Stream& stream : streams_) longest = std::max(longest, stream.rows);
    for (Stream& stream : streams_) {
      if (stream.rows > short_vector || longest <= short_vector) {
        recording_.streams.push_back(std::move(stream));
        continue;
      }
      for (const Channel& channel : stream.channels)
        recording_.metadata.emplace_back(channel.name, as_text(channel));
    }
    if (recording_.streams.size() == 1) recording_.streams.front().name.clear();
  }

 private:
  static std::string as_text(const Channel& channel) {
    std::string text = "[";
    for (const double value : channel.values)
      text += (text.size() > 1 ? " " : "") + config::plain_number(value);
    return text + "]";
  }

  void take_matrix(const MatVariable& matrix) {
    const bool is_upright = matrix.rows >= matrix.columns;
    const std::size_t length = is_upright ? matrix.rows : matrix.columns;
    const std::size_t count = is_upright ? matrix.columns : matrix.rows;
    if (count > max_columns) {
      recording_.remarks.push_back("'" + matrix.name + "' has " + std::to_string(matrix.rows) + " x " +
                                   std::to_string(matrix.columns) +
                                   " values, too many columns for a log: left out");
      return;
    }
    Stream& stream = stream_for(length);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string number = std::to_string(i + 1);
      Channel channel{matrix.name + (is_upright ? "(:," + number + ")" : "(" + number + ",:)"), {}, {}};
      channel.values.reserve(length);
      for (std::size_t row = 0; row < length; ++row)
        channel.values.push_back(matrix.values[is_upright ? i * length + row : row * count + i]);
      stream.channels.push_back(std::move(channel));
    }
  }

  Stream& stream_for(std::size_t length) {
    const auto [found, is_new] = numbers_.try_emplace(length, streams_.size());
    if (is_new) {
      streams_.emplace_back();
      streams_.back().rows = length;
      streams_.back().name = std::to_string(length) + " values";
    }
    return streams_[found->second];
  }

  Recording& recording_;
  std::vector<Stream> streams_;
  std::map<std::size_t, std::size_t> numbers_;  // of streams, by length
};

}  // namespace

bool is_mat_file(std::string_view head) {
  return is_level5(head) || head.starts_with("MATLAB 7.3") || is_level4(head);
}

ReadResult read_mat_file(std::string_view bytes, const std::string& name) {
  if (is_hdf5(bytes)) {
    return tl::unexpected(name + ": a MATLAB file of version 7.3 (HDF5), which is not read; save it with " +
                          "save('log.mat', '-v7')");
  }
  Recording recording;
  recording.name = name;
  MatContents contents;
  if (is_level5(bytes)) {
    const auto version = bytes.substr(126, 2) == "MI" ? bytes[124] : bytes[125];
    if (version != 1) return tl::unexpected(name + ": a MATLAB file of unknown version; save it with -v7");
    recording.format = "MATLAB file, level 5 (" + header_text(bytes) + ")";
    read_level5(bytes, contents);
  } else if (is_level4(bytes)) {
    recording.format = "MATLAB file, level 4";
    read_level4(bytes, contents);
  } else {
    return tl::unexpected(name + ": is no MATLAB file, or cut short within its header of 128 bytes");
  }
  recording.metadata = std::move(contents.texts);
  recording.remarks = std::move(contents.remarks);
  Sorter sorter(recording);
  for (MatVariable& variable : contents.variables) sorter.take(std::move(variable));
  sorter.finish();
  if (recording.streams.empty()) {
    const std::string why = recording.remarks.empty() ? "" : " (" + recording.remarks.front() + ")";
    return tl::unexpected(name + ": a MATLAB file without a numeric vector or matrix" + why);
  }
  return recording;
}

}  // namespace wheelwright::import
