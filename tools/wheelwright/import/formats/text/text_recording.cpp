#include "tools/wheelwright/import/formats/text/text_recording.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/echo/message_columns.hpp"
#include "tools/wheelwright/import/formats/ros/echo/yaml_messages.hpp"
#include "tools/wheelwright/import/formats/text/decimal_comma.hpp"
#include "tools/wheelwright/import/formats/text/dialect_sniffer.hpp"
#include "tools/wheelwright/import/formats/text/json_document.hpp"
#include "tools/wheelwright/import/formats/text/json_lines.hpp"
#include "tools/wheelwright/import/formats/text/keyed_lines.hpp"
#include "tools/wheelwright/import/formats/text/run_column.hpp"
#include "tools/wheelwright/import/formats/text/stamp_text.hpp"
#include "tools/wheelwright/import/formats/text/table_layout.hpp"
#include "tools/wheelwright/import/formats/text/table_reader.hpp"
#include "tools/wheelwright/import/formats/text/table_streams.hpp"
#include "tools/wheelwright/import/formats/text/text_sample.hpp"

namespace wheelwright::import {
namespace {

using Failure = tl::unexpected<std::string>;

constexpr double min_table_score = 0.05;
constexpr double min_keyed_share = 0.4;
constexpr double regular_rows = 0.9;
constexpr std::size_t max_remarks = 60;

// "sep=;", which Excel reads in a first line; its characters become blanks, so that line numbers stay.
char take_separator_line(std::string& text) {
  const auto end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = trim(std::string_view(text).substr(0, end));
  if (line.size() < 5 || line.size() > 7) return '\0';
  const std::string_view bare = line.front() == '"' ? line.substr(1, line.size() - 2) : line;
  if (!bare.starts_with("sep=") && !bare.starts_with("SEP=")) return '\0';
  const char separator = bare.size() == 4 ? '\t' : bare[4];
  std::fill_n(text.begin(), end, ' ');
  return separator;
}

std::size_t mean_row_bytes(const TextSample& sample) {
  std::size_t bytes = 0;
  for (const std::string_view line : sample.contents) bytes += line.size() + 1;
  return bytes / std::max<std::size_t>(sample.contents.size(), 1);
}

bool begins_with_text(const TextSample& sample, const SniffedTable& table) {
  const std::size_t first = table.dialect.rows_are_stamped ? 1 : 0;
  const auto kinds = column_kinds(sample.contents, table.dialect, table.width);
  return first >= kinds.size() || kinds[first] == ColumnKind::text;
}

// Rows whose first cell is a number make a table, also where a text stands in another; a first cell of text
// is a key, unless there are names above it.
bool are_keyed(const TextSample& sample, const SniffedTable& table, const TableLayout& layout) {
  const double keyed = share_of_keyed_lines(sample);
  if (keyed >= min_keyed_share && are_assignments(sample)) return true;
  if (keyed < min_keyed_share || keyed <= table.score()) return false;
  if (table.score() < min_table_score) return true;
  if (!begins_with_text(sample, table)) return table.share_of_rows < regular_rows && layout.header.empty();
  return layout.header.empty() || table.dialect.separator == ' ';
}

std::string in_words(const SniffedTable& table, const TableLayout& layout) {
  const char separator = table.dialect.separator;
  const bool is_csv = separator == ',' || separator == ';' || separator == '\t';
  std::string words = (is_csv ? "CSV: " : "text table: ") + in_words(table.dialect);
  if (layout.header.empty()) return words + ", no header row";
  words += layout.header_is_comment ? ", header row in a comment" : ", header row";
  return words + (layout.has_units_row ? ", units beneath it" : "");
}

// Each message ends with a line of its own.
bool are_yaml_messages(const TextSample& sample) {
  return std::ranges::count_if(sample.contents, [](std::string_view line) { return trim(line) == "---"; }) >
         1;
}

std::string refusal(const TextSample& sample) {
  if (sample.contents.empty()) return "holds comments only; a table of numbers is needed";
  if (sample.contents.size() == 1) {
    return "holds one line, '" + config::excerpt(trim(sample.contents.front())) + "', and no rows of numbers";
  }
  return "no table of numbers, and no lines with a word and its numbers (the first line is '" +
         config::excerpt(trim(sample.contents.front())) + "')";
}

// Names the columns of messages that 'ros2 topic echo --csv' has printed, and returns their type.
std::optional<std::string> take_message_names(std::vector<TextTable>& tables) {
  if (tables.size() != 1) return std::nullopt;
  TextTable& table = tables.front();
  std::vector<ros::ColumnContent> contents;
  for (std::size_t i = 0; i < table.width(); ++i) {
    const bool is_text = table.columns[i].kind == ColumnKind::text;
    contents.push_back(
        {table.values[i], is_text ? std::span(table.labels[i].names()) : std::span<const std::string>()});
  }
  auto message = ros::recognise_message(contents);
  if (!message) return std::nullopt;
  for (std::size_t i = 0; i < table.width(); ++i) table.columns[i].name = message->names[i];
  return message->type;
}

class TextReader {
 public:
  TextReader(std::string bytes, std::string name) {
    recording_.name = std::move(name);
    decoded_ = decode_text(std::move(bytes));
  }

  ReadResult read() {
    recording_.remarks = std::move(decoded_.remarks);
    if (decoded_.text.find_first_not_of(" \t\r\n") == std::string::npos) {
      return fail("holds nothing; a table of numbers is needed");
    }
    const char separator = take_separator_line(decoded_.text);
    point_milliseconds(decoded_.text);
    const TextSample sample = take_sample(decoded_.text);
    const bool may_be_json = sample.contents.size() < 2 || !are_json_lines(sample);
    if (auto document = may_be_json ? read_json_document(decoded_.text) : std::nullopt) {
      recording_.metadata = std::move(document->metadata);
      return finish("JSON", std::move(document->streams));
    }
    if (are_json_lines(sample))
      return finish("JSON, one object a line", read_json_lines(decoded_.text, recording_.remarks));
    SniffedTable table = sniff_table(sample, separator);
    TableLayout layout;
    if (table.score() >= min_table_score) layout = find_layout(sample, table);
    const bool is_weak = table.score() < min_table_score;
    if (are_yaml_messages(sample)) {
      auto stream = ros::read_yaml_messages(decoded_.text, recording_.remarks);
      if (stream) return finish("ROS messages as text (YAML)", {*std::move(stream)});
    }
    if (are_keyed(sample, table, layout)) {
      return finish("text, lines of a key and its numbers",
                    read_keyed_lines(decoded_.text, recording_.remarks));
    }
    if (is_weak) return fail(refusal(sample));
    const CommaVerdict comma = judge_comma(sample, table.dialect, layout.header);
    if (comma.meaning == CommaMeaning::both) return fail(comma.text);
    if (comma.meaning == CommaMeaning::decimal) {
      table = as_single_decimal_column(table);
      layout = find_layout(sample, table);
    }
    if (!comma.text.empty()) recording_.remarks.push_back(comma.text);
    return read_table(sample, table, std::move(layout));
  }

 private:
  tl::unexpected<std::string> fail(const std::string& what) const {
    return Failure(recording_.name + ": " + what);
  }

  ReadResult read_table(const TextSample& sample, const SniffedTable& table, TableLayout layout) {
    auto tables = read_tables(decoded_.text, table.dialect, layout, mean_row_bytes(sample));
    if (!tables) return fail(tables.error());
    recording_.metadata = std::move(layout.metadata);
    std::ranges::move(tables->metadata, std::back_inserter(recording_.metadata));
    std::ranges::move(layout.remarks, std::back_inserter(recording_.remarks));
    std::ranges::move(tables->remarks, std::back_inserter(recording_.remarks));
    std::erase_if(tables->tables, [](const TextTable& each) { return each.rows() == 0; });
    std::vector<Stream> streams;
    const bool are_several = tables->tables.size() > 1;
    const auto message =
        !are_several && layout.header.empty() ? take_message_names(tables->tables) : std::nullopt;
    for (std::size_t i = 0; i < tables->tables.size(); ++i) {
      const std::string name = are_several ? "table " + std::to_string(i + 1) : "";
      std::ranges::move(make_streams(std::move(tables->tables[i]), name, recording_.remarks),
                        std::back_inserter(streams));
    }
    std::string format = in_words(table, layout);
    if (message) {
      for (Stream& stream : streams) stream.type = *message;
      format += ", messages of " + (message->empty() ? "a type that is not known" : *message);
    }
    return finish(std::move(format), std::move(streams));
  }

  ReadResult finish(std::string format, std::vector<Stream> streams) {
    std::erase_if(streams, [](const Stream& stream) { return stream.channels.empty(); });
    if (streams.empty()) return fail("holds no numbers; a table of numbers is needed");
    for (Stream& stream : streams) find_runs(stream, recording_.remarks);
    recording_.format = std::move(format);
    if (!decoded_.encoding.empty()) recording_.format += "; " + decoded_.encoding;
    recording_.streams = std::move(streams);
    auto& remarks = recording_.remarks;
    if (remarks.size() > max_remarks) {
      const std::size_t more = remarks.size() - max_remarks;
      remarks.resize(max_remarks);
      remarks.push_back(std::to_string(more) + " more remarks of this kind");
    }
    return std::move(recording_);
  }

  Recording recording_;
  DecodedText decoded_;
};

}  // namespace

ReadResult read_text_table(std::string text, std::string name) {
  return TextReader(std::move(text), std::move(name)).read();
}

}  // namespace wheelwright::import
