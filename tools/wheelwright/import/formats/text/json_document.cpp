#include "tools/wheelwright/import/formats/text/json_document.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t deepest = 24;
constexpr std::size_t max_row_members = 4096;
constexpr std::size_t max_kinds = 256;  // of rows, and columns
constexpr std::size_t max_pairs = 200;
constexpr std::size_t min_column_rows = 2;

// Takes what the parser calls it for. An object or array within an array is a row, with all that is in it.
class Collector {
 public:
  JsonDocument finish() {
    for (auto& [key, stream] : rows_of_kind_) document_.streams.push_back(std::move(stream));
    for (auto& [length, stream] : columns_by_length()) document_.streams.push_back(std::move(stream));
    name_streams();
    return std::move(document_);
  }

  bool null() { return put(nothing); }
  bool boolean(bool value) { return put(value ? 1.0 : 0.0); }
  bool number_integer(std::int64_t value) { return put(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return put(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(const std::string& text) {
    if (!is_in_row() && !is_in_array() && document_.metadata.size() < max_pairs)
      document_.metadata.emplace_back(path_, text);
    step();
    return true;
  }
  bool binary(const std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return open(false); }
  bool start_array(std::size_t) { return open(true); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(const std::string& name) {
    path_.resize(levels_.back().path_length);
    path_ += (path_.size() > row_path_length_ ? "." : "") + name;
    return true;
  }
  template <typename Error>
  bool parse_error(std::size_t, const std::string&, const Error&) {
    return false;
  }

 private:
  struct Level {
    std::size_t path_length = 0;
    std::size_t index = 0;
    bool is_array = false;
  };

  bool is_in_array() const { return !levels_.empty() && levels_.back().is_array; }
  bool is_in_row() const { return row_depth_ > 0; }

  // The next element of an array within a row: "pose[0]"; "1" of a row that is an array.
  void step() {
    if (!is_in_array() || !is_in_row()) return;
    path_.resize(levels_.back().path_length);
    const std::size_t index = levels_.back().index++;
    path_ += levels_.size() == row_depth_ ? std::to_string(index + 1) : "[" + std::to_string(index) + "]";
  }

  bool put(double value) {
    step();
    if (is_in_row()) {
      row_.emplace_back(path_.substr(row_path_length_), value);
      return row_.size() <= max_row_members;
    }
    if (is_in_array()) {
      columns_[path_].push_back(value);
      return columns_.size() <= max_kinds;
    }
    if (document_.metadata.size() < max_pairs)
      document_.metadata.emplace_back(path_, config::plain_number(value));
    return true;
  }

  bool open(bool is_array) {
    step();
    const bool begins_row = !is_in_row() && is_in_array();
    levels_.push_back({path_.size(), 0, is_array});
    if (begins_row) {
      row_depth_ = levels_.size();
      row_path_length_ = path_.size();
    }
    return levels_.size() <= deepest;
  }

  bool close() {
    const bool ends_row = levels_.size() == row_depth_;
    path_.resize(levels_.back().path_length);
    levels_.pop_back();
    return !ends_row || end_row();
  }

  bool end_row() {
    std::string kind = path_;
    for (const auto& [name, value] : row_) kind += '\n' + name;
    row_depth_ = 0;
    row_path_length_ = 0;
    if (row_.empty()) return true;
    Stream& stream = rows_of_kind_[kind];
    if (stream.channels.empty()) {
      stream.name = path_;
      for (const auto& [name, value] : row_) stream.channels.push_back({name, {}, {}});
    }
    for (std::size_t i = 0; i < row_.size(); ++i) stream.channels[i].values.push_back(row_[i].second);
    ++stream.rows;
    row_.clear();
    return rows_of_kind_.size() <= max_kinds;
  }

  std::map<std::size_t, Stream> columns_by_length() {
    std::map<std::size_t, Stream> streams;
    for (auto& [name, values] : columns_) {
      if (values.size() < min_column_rows) continue;
      Stream& stream = streams[values.size()];
      stream.rows = values.size();
      stream.channels.push_back({name.empty() ? "1" : name, {}, std::move(values)});
    }
    return streams;
  }

  // A file with one table needs no name for it.
  void name_streams() {
    if (document_.streams.size() == 1) document_.streams.front().name.clear();
    for (std::size_t i = 0; document_.streams.size() > 1 && i < document_.streams.size(); ++i) {
      std::string& name = document_.streams[i].name;
      const bool is_taken = std::ranges::count(document_.streams, name, &Stream::name) > 1;
      if (name.empty() || is_taken) name += (name.empty() ? "form " : " ") + std::to_string(i + 1);
    }
  }

  JsonDocument document_;
  std::string path_;
  std::vector<Level> levels_;
  std::size_t row_depth_ = 0;  // of levels; 0 outside of rows
  std::size_t row_path_length_ = 0;
  std::vector<std::pair<std::string, double>> row_;
  std::map<std::string, Stream> rows_of_kind_;
  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace

std::optional<JsonDocument> read_json_document(std::string_view text) {
  text = trim(text);
  const bool may_be_one =
      (text.starts_with('[') && text.ends_with(']')) || (text.starts_with('{') && text.ends_with('}'));
  Collector collector;
  if (!may_be_one || !nlohmann::json::sax_parse(text.begin(), text.end(), &collector)) return std::nullopt;
  JsonDocument document = collector.finish();
  return document.streams.empty() ? std::nullopt : std::optional(std::move(document));
}

}  // namespace wheelwright::import
