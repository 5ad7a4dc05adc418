#include "tools/wheelwright/import/formats/text/table_streams.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/text/direction_words.hpp"
#include "tools/wheelwright/import/formats/text/row_kinds.hpp"
#include "tools/wheelwright/import/formats/text/run_column.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t labels_in_remark = 6;

std::string in_quotes(const std::string& text) {
  return "'" + config::excerpt(text) + "'";
}

void erase_column(TextTable& table, std::size_t at) {
  const auto offset = static_cast<std::ptrdiff_t>(at);
  table.columns.erase(table.columns.begin() + offset);
  table.values.erase(table.values.begin() + offset);
  table.labels.erase(table.labels.begin() + offset);
  if (at < table.header.size()) table.header.erase(table.header.begin() + offset);
}

bool has_name(const TextTable& table, std::size_t column) {
  return column < table.header.size() && !trim(table.header[column]).empty();
}

bool is_empty(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isnan(value); });
}

// Separators at the beginning or end of each row.
void drop_nameless_empty_columns(TextTable& table) {
  for (std::size_t i = table.width(); i-- > 0;) {
    if (!has_name(table, i) && is_empty(table.values[i])) erase_column(table, i);
  }
}

// 0, 1, 2 ... or 1, 2, 3 ... under no name, as pandas and R write it.
void drop_index_column(TextTable& table, std::vector<std::string>& remarks) {
  if (table.header.empty() || table.width() < 2 || table.rows() < 2) return;
  const bool is_nameless = !has_name(table, 0) || table.header[0].starts_with("Unnamed: ");
  const std::vector<double>& values = table.values[0];
  if (!is_nameless || (values[0] != 0.0 && values[0] != 1.0)) return;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] != values[0] + static_cast<double>(i)) return;
  }
  remarks.push_back("the first column has no name and counts the rows from " +
                    std::string(values[0] == 0.0 ? "0" : "1") + ": left out");
  erase_column(table, 0);
}

// A date in one column, the time of day in the next, or the other way round.
void join_date_and_clock(TextTable& table, std::vector<std::string>& remarks) {
  for (std::size_t i = 0; i + 1 < table.width(); ++i) {
    const ColumnKind first = table.columns[i].kind;
    const ColumnKind second = table.columns[i + 1].kind;
    const bool are_parts = (first == ColumnKind::date && second == ColumnKind::clock) ||
                           (first == ColumnKind::clock && second == ColumnKind::date);
    if (!are_parts) continue;
    for (std::size_t row = 0; row < table.rows(); ++row) table.values[i][row] += table.values[i + 1][row];
    remarks.push_back("columns " + in_quotes(table.columns[i].name) + " and " +
                      in_quotes(table.columns[i + 1].name) + " are a date and its time: joined");
    table.columns[i].name += " " + table.columns[i + 1].name;
    table.columns[i].kind = ColumnKind::date_and_time;
    erase_column(table, i + 1);
  }
}

std::string describe_texts(const Labels& labels) {
  if (labels.are_too_many()) return "more than " + std::to_string(Labels::max_labels) + " different texts";
  std::string words;
  for (std::size_t i = 0; i < std::min(labels.names().size(), labels_in_remark); ++i)
    words += (i > 0 ? ", " : "") + in_quotes(labels.names()[i]);
  return labels.names().size() > labels_in_remark ? words + " ..." : words;
}

// The texts of a column that tells runs apart become numbers.
void number_runs(TextTable& table, std::vector<std::string>& remarks) {
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (table.columns[i].kind != ColumnKind::text || table.labels[i].are_too_many() ||
        !names_a_run(table.columns[i].name) || !are_stretches(table.values[i]))
      continue;
    table.columns[i].kind = ColumnKind::number;
    remarks.push_back("column " + in_quotes(table.columns[i].name) + " holds text (" +
                      describe_texts(table.labels[i]) + "): numbered from 0");
  }
}

void drop_empty_columns(TextTable& table, std::vector<std::string>& remarks) {
  std::string names;
  for (std::size_t i = table.width(); i-- > 0;) {
    if (table.columns[i].kind != ColumnKind::text || !table.labels[i].names().empty()) continue;
    names = in_quotes(table.columns[i].name) + (names.empty() ? "" : ", ") + names;
    erase_column(table, i);
  }
  if (!names.empty()) remarks.push_back("no value in any row of " + names + ": left out");
}

void drop_text_columns(TextTable& table, std::vector<std::string>& remarks) {
  drop_empty_columns(table, remarks);
  for (std::size_t i = table.width(); i-- > 0;) {
    if (table.columns[i].kind != ColumnKind::text) continue;
    remarks.push_back("column " + in_quotes(table.columns[i].name) + " holds text (" +
                      describe_texts(table.labels[i]) + "): left out");
    erase_column(table, i);
  }
}

std::string unit_of(const Column& column) {
  if (column.kind == ColumnKind::number) return column.unit;
  return column.kind == ColumnKind::clock ? "hms" : "iso";
}

Stream make_stream(TextTable& table, const std::string& name) {
  Stream stream;
  stream.name = name;
  stream.rows = table.rows();
  stream.places = std::move(table.places);
  for (std::size_t i = 0; i < table.width(); ++i)
    stream.channels.push_back({table.columns[i].name, unit_of(table.columns[i]), std::move(table.values[i])});
  return stream;
}

// Each column is taken apart by itself, so that no more than one is held twice.
std::vector<Stream> part_by_label(TextTable& table, const std::vector<double>& label_of_row,
                                  const std::vector<std::string>& labels, const std::string& prefix) {
  std::vector<Stream> streams(labels.size() + 1);  // the last one: rows without a label
  const auto stream_of = [&](std::size_t row) -> Stream& {
    const double label = label_of_row[row];
    return streams[std::isnan(label) ? labels.size() : static_cast<std::size_t>(label)];
  };
  for (std::size_t row = 0; row < table.rows(); ++row) stream_of(row).places.push_back(table.places[row]);
  for (std::size_t i = 0; i < table.width(); ++i) {
    for (Stream& stream : streams) {
      stream.channels.push_back({table.columns[i].name, unit_of(table.columns[i]), {}});
      stream.channels.back().values.reserve(stream.places.size());
    }
    for (std::size_t row = 0; row < table.rows(); ++row)
      stream_of(row).channels.back().values.push_back(table.values[i][row]);
    table.values[i] = {};
    for (Stream& stream : streams) {
      if (is_empty(stream.channels.back().values)) stream.channels.pop_back();
    }
  }
  for (std::size_t i = 0; i < streams.size(); ++i) {
    streams[i].name = prefix + (i < labels.size() ? labels[i] : "without a label");
    streams[i].rows = streams[i].places.size();
  }
  std::erase_if(streams, [](const Stream& stream) { return stream.rows == 0; });
  return streams;
}

}  // namespace

std::vector<Stream> make_streams(TextTable table, const std::string& name,
                                 std::vector<std::string>& remarks) {
  drop_nameless_empty_columns(table);
  drop_index_column(table, remarks);
  join_date_and_clock(table, remarks);
  read_direction_words(table, remarks);
  label_numbers(table);
  std::vector<double> label_of_row;
  Labels labels;
  if (const auto column = find_kind_column(table)) {
    remarks.push_back("column " + in_quotes(table.columns[*column].name) + " parts the rows into " +
                      std::to_string(table.labels[*column].names().size()) + " streams");
    label_of_row = std::move(table.values[*column]);
    labels = std::move(table.labels[*column]);
    erase_column(table, *column);
  }
  number_runs(table, remarks);
  drop_text_columns(table, remarks);
  std::vector<Stream> streams;
  if (label_of_row.empty()) {
    streams.push_back(make_stream(table, name));
  } else {
    streams = part_by_label(table, label_of_row, labels.names(), name.empty() ? "" : name + " ");
  }
  return streams;
}

}  // namespace wheelwright::import
