#include "tools/wheelwright/import/formats/text/table_reader.hpp"

#include <algorithm>
#include <optional>

#include "config/load/cut_row.hpp"
#include "tools/wheelwright/import/formats/text/header_text.hpp"

namespace wheelwright::import {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t max_cells = 160'000'000;  // 1.3 GB of numbers
constexpr std::size_t max_tables = 200;
constexpr std::size_t max_looks_ahead = 20'000;
constexpr std::size_t lines_ahead = 20;
constexpr std::size_t rows_of_a_table = 5;  // without a header: as many of one width
constexpr std::size_t max_metadata = 200;

std::string with_point(std::string_view cell, char decimal) {
  std::string text(cell);
  if (decimal == ',') std::ranges::replace(text, ',', '.');
  return text;
}

class Reader {
 public:
  Reader(std::string_view text, const Dialect& dialect, const TableLayout& layout)
      : cursor_(text), dialect_(dialect), first_line_(layout.first_row_line) {
    result_.tables.emplace_back(layout.columns, layout.header);
  }

  tl::expected<TextTables, std::string> read(std::size_t rows_expected) {
    table().reserve(rows_expected);
    Line line;
    while (cursor_.next_filled(line)) {
      if (line.number < first_line_) continue;
      if (is_comment(line.text)) {
        take_comment(line);
      } else {
        take_line(line);
      }
      if (cells_taken_ > max_cells) {
        return tl::unexpected("line " + std::to_string(line.number) + ": more than " +
                              std::to_string(max_cells / 1'000'000) +
                              " million fields up to here; split the file");
      }
    }
    say_remarks();
    return std::move(result_);
  }

 private:
  TextTable& table() { return result_.tables[current_]; }

  void take_line(const Line& line) {
    split_row(line.text, dialect_, cells_);
    const std::size_t width = width_of(cells_, table().width());
    if (line.is_open_ended && is_cut(line, width)) {
      cut_rows_.add(line);
      return;
    }
    const bool has_width = width == table().width();
    if (has_width && table().take(cells_, line, dialect_) == TextTable::Taken::row) {
      cells_taken_ += width;
      row_above_ = line.text;
      return;
    }
    if (is_units_beneath_header(line)) return;
    if (is_header_row(cells_, dialect_)) {
      take_header(line);
    } else if (!has_width && begins_rows_of_width(width)) {
      Cells rows = lines_ahead_;
      rows.push_back(line.text);
      if (begin_table({}, column_kinds(rows, dialect_, width), width)) {
        take_line(line);
      } else {
        other_widths_.add(line);
      }
    } else {
      (has_width ? texts_ : other_widths_).add(line);
    }
  }

  // Fewer fields than the rows above, or figures lost in the last of them.
  bool is_cut(const Line& line, std::size_t width) {
    if (table().rows() == 0) return false;
    if (dialect_.rows_are_quoted && !trim(line.text).ends_with('"')) return true;
    if (width < table().width()) return true;
    if (width > table().width() || cells_.empty()) return false;
    const std::string last = with_point(cells_[width - 1], dialect_.decimal);
    Cells above;
    split_row(row_above_, dialect_, above);
    if (above.size() < width) return false;
    return (last.empty() && !above[width - 1].empty()) ||
           config::has_lost_figures(last, with_point(above[width - 1], dialect_.decimal));
  }

  bool is_units_beneath_header(const Line& line) {
    if (header_line_ == 0 || line.number != header_line_ + 1) return false;
    return is_units_row(std::vector<std::string>(cells_.begin(), cells_.end()));
  }

  void take_header(const Line& line) {
    std::vector<std::string> header;
    for (const std::string_view cell : cells_) header.push_back(unescape_quotes(cell));
    if (dialect_.rows_are_stamped && !header.empty()) header.front() = "stamp";
    while (header.size() > 1 && header.back().empty()) header.pop_back();
    if (is_header_of(table(), header)) {
      repeated_headers_.add(line);
      header_line_ = line.number;
      return;
    }
    const std::size_t width = header.size();
    const bool has_rows = width > 1 && look_ahead() && has_row_ahead(width);
    if (!has_rows) {
      texts_.add(line);
      return;
    }
    if (!begin_table(header, column_kinds(lines_ahead_, dialect_, width), width)) {
      texts_.add(line);
      return;
    }
    header_line_ = line.number;
  }

  bool is_header_of(const TextTable& table, const std::vector<std::string>& header) const {
    const std::size_t first = dialect_.rows_are_stamped ? 1 : 0;
    if (table.header.size() < header.size() || header.size() <= first) return false;
    for (std::size_t i = first; i < table.header.size(); ++i) {
      if (i < header.size() ? table.header[i] != header[i] : !table.header[i].empty()) return false;
    }
    return true;
  }

  // One of the next two lines is a row: there may be units beneath a header.
  bool has_row_ahead(std::size_t width) {
    const auto kinds = column_kinds(lines_ahead_, dialect_, width);
    Cells cells;
    for (std::size_t i = 0; i < std::min<std::size_t>(lines_ahead_.size(), 2); ++i) {
      split_row(lines_ahead_[i], dialect_, cells);
      if (width_of(cells, width) == width && is_data_row(cells, kinds, dialect_)) return true;
    }
    return false;
  }

  bool begins_rows_of_width(std::size_t width) {
    if (width > max_columns || width < 1 || !look_ahead() || lines_ahead_.size() + 1 < rows_of_a_table)
      return false;
    Cells cells;
    for (std::size_t i = 0; i + 1 < rows_of_a_table; ++i) {
      split_row(lines_ahead_[i], dialect_, cells);
      if (width_of(cells, width) != width || is_header_row(cells, dialect_)) return false;
    }
    return true;
  }

  // The next lines that are neither blank nor comments; false where this was done too often.
  bool look_ahead() {
    if (++looks_ahead_ > max_looks_ahead) return false;
    lines_ahead_.clear();
    LineCursor ahead = cursor_;
    Line line;
    for (std::size_t i = 0; i < lines_ahead && ahead.next_filled(line); ++i) {
      if (!is_comment(line.text)) lines_ahead_.push_back(line.text);
    }
    return true;
  }

  // Goes on with an earlier table where its header comes again; false where there are too many tables.
  bool begin_table(const std::vector<std::string>& header, const std::vector<ColumnKind>& kinds,
                   std::size_t width) {
    for (std::size_t i = 0; i < result_.tables.size(); ++i) {
      const TextTable& earlier = result_.tables[i];
      if (earlier.width() == width && earlier.header == header) {
        current_ = i;
        return true;
      }
    }
    if (result_.tables.size() == max_tables) return false;
    current_ = result_.tables.size();
    result_.tables.emplace_back(name_columns(header, kinds, result_.remarks), header);
    if (dialect_.rows_are_stamped) table().columns.front().name = "stamp";
    return true;
  }

  void take_comment(const Line& line) {
    const std::string_view text = comment_text(line.text);
    if (text.empty()) return;
    auto names = comment_header(line.text, dialect_, table().width());
    if (!names.empty() && is_header_of(table(), names)) {
      repeated_headers_.add(line);
      return;
    }
    if (begin_table_of_comment(line)) return;
    auto pair = key_and_value(text);
    if (pair && result_.metadata.size() < max_metadata) {
      result_.metadata.push_back(*std::move(pair));
    } else {
      comments_.add(line);
    }
  }

  // "# t;x;y" above rows of another width than before.
  bool begin_table_of_comment(const Line& line) {
    if (!look_ahead() || lines_ahead_.empty()) return false;
    Cells cells;
    split_row(lines_ahead_.front(), dialect_, cells);
    if (cells.size() == table().width() || cells.size() > max_columns) return false;
    const auto names = comment_header(line.text, dialect_, cells.size());
    if (names.empty() || !has_row_ahead(cells.size())) return false;
    return begin_table(names, column_kinds(lines_ahead_, dialect_, cells.size()), cells.size());
  }

  void say_remarks() {
    auto& remarks = result_.remarks;
    repeated_headers_.say("the header row once more, left out", remarks);
    other_widths_.say("not as many fields as the other rows, left out", remarks);
    texts_.say("no row of numbers, left out", remarks);
    comments_.say("a comment between the rows, left out", remarks);
    cut_rows_.say("the last row is cut short, without a line break at its end: left out", remarks);
    for (const TextTable& each : result_.tables) each.say_unread_cells(remarks);
  }

  LineCursor cursor_;
  const Dialect dialect_;
  const std::size_t first_line_;
  TextTables result_;
  std::size_t current_ = 0;  // table
  Cells cells_;
  std::string_view row_above_;
  Cells lines_ahead_;
  std::size_t looks_ahead_ = 0;
  std::size_t header_line_ = 0;
  std::size_t cells_taken_ = 0;
  LineTally repeated_headers_, other_widths_, texts_, comments_, cut_rows_;
};

}  // namespace

tl::expected<TextTables, std::string> read_tables(std::string_view text, const Dialect& dialect,
                                                  const TableLayout& layout, std::size_t bytes_of_a_row) {
  const std::size_t rows = text.size() / std::max<std::size_t>(bytes_of_a_row, 1) + 16;
  const std::size_t columns = std::max<std::size_t>(layout.columns.size(), 1);
  return Reader(text, dialect, layout).read(std::min(rows + rows / 32, max_cells / columns));
}

}  // namespace wheelwright::import
