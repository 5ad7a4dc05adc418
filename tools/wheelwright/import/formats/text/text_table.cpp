#include "tools/wheelwright/import/formats/text/text_table.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "tools/wheelwright/import/formats/text/number_text.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

bool fits(TimeForm form, ColumnKind kind) {
  if (kind == ColumnKind::clock) return form == TimeForm::clock;
  if (kind == ColumnKind::date) return form == TimeForm::date;
  return form != TimeForm::clock;  // midnight is often written without a time
}

std::optional<double> read_cell(std::string_view cell, ColumnKind kind, const Dialect& dialect) {
  if (kind == ColumnKind::number) {
    if (const auto number = read_number(cell, dialect.decimal, dialect.has_groups)) return number;
    const auto with_unit = read_number_with_unit(cell, dialect.decimal);
    return with_unit ? std::optional(with_unit->value) : std::nullopt;
  }
  const auto time = read_time(cell, dialect.date_order);
  return time && fits(time->form, kind) ? std::optional(time->seconds) : std::nullopt;
}

}  // namespace

double Labels::number_of(std::string_view text) {
  if (are_too_many_) return nothing;
  if (last_ < names_.size() && names_[last_] == text) return static_cast<double>(last_);
  const auto found = numbers_.find(text);
  if (found == numbers_.end() && names_.size() == max_labels) {
    are_too_many_ = true;
    return nothing;
  }
  if (found == numbers_.end()) {
    last_ = names_.size();
    numbers_.emplace(text, last_);
    names_.emplace_back(text);
  } else {
    last_ = found->second;
  }
  return static_cast<double>(last_);
}

TextTable::TextTable(std::vector<Column> columns_found, std::vector<std::string> header_found)
    : columns(std::move(columns_found)),
      header(std::move(header_found)),
      values(columns.size()),
      labels(columns.size()),
      row_(columns.size()),
      unread_cells_(columns.size()) {}

TextTable::Taken TextTable::take(const std::vector<std::string_view>& cells, const Line& line,
                                 const Dialect& dialect) {
  std::size_t read = 0;
  unread_.clear();
  for (std::size_t i = 0; i < width(); ++i) {
    const ColumnKind kind = columns[i].kind;
    if (kind == ColumnKind::text) {
      row_[i] = cells[i].empty() ? nothing : labels[i].number_of(cells[i]);
      continue;
    }
    const auto value = read_cell(cells[i], kind, dialect);
    row_[i] = value.value_or(nothing);
    if (value) {
      ++read;
    } else if (!is_missing(cells[i])) {
      unread_.push_back(i);
    }
  }
  if (dialect.rows_are_stamped && read > 0) --read;  // the stamp shows nothing about the rest
  if (!unread_.empty() && unread_.size() > read) return Taken::text;
  for (const std::size_t i : unread_) unread_cells_[i].add(line.number, cells[i]);
  for (std::size_t i = 0; i < width(); ++i) values[i].push_back(row_[i]);
  places.push_back(line.number);
  return Taken::row;
}

void TextTable::reserve(std::size_t rows) {
  for (auto& column : values) column.reserve(rows);
  places.reserve(rows);
}

void TextTable::say_unread_cells(std::vector<std::string>& remarks) const {
  for (std::size_t i = 0; i < width(); ++i) {
    unread_cells_[i].say("no number in column '" + config::excerpt(columns[i].name) + "', taken as missing",
                         remarks);
  }
}

}  // namespace wheelwright::import
