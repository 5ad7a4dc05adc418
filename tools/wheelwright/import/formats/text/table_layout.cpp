#include "tools/wheelwright/import/formats/text/table_layout.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/text/header_text.hpp"
#include "tools/wheelwright/import/formats/text/number_text.hpp"

namespace wheelwright::import {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t max_remarks_above = 8;
constexpr std::size_t kind_count = 5;

std::optional<ColumnKind> kind_of(std::string_view cell, const Dialect& dialect) {
  if (is_missing(cell)) return std::nullopt;
  if (read_number(cell, dialect.decimal, dialect.has_groups)) return ColumnKind::number;
  if (read_number_with_unit(cell, dialect.decimal)) return ColumnKind::number;
  const auto time = read_time(cell, dialect.date_order);
  if (!time) return ColumnKind::text;
  if (time->form == TimeForm::clock) return ColumnKind::clock;
  return time->form == TimeForm::date ? ColumnKind::date : ColumnKind::date_and_time;
}

// A stamp stands before header rows as well.
std::size_t first_own_column(const Dialect& dialect) {
  return dialect.rows_are_stamped ? 1 : 0;
}

// "0,1,2,3" or ",0,1,2", which pandas writes above columns without names.
bool is_row_of_column_numbers(const Cells& cells) {
  const std::size_t first = !cells.empty() && cells.front().empty() ? 1 : 0;
  if (cells.size() < 4 - first) return false;
  for (std::size_t i = first; i < cells.size(); ++i) {
    if (cells[i] != std::to_string(i - first)) return false;
  }
  return true;
}

bool is_first_data_row(const Cells& cells, const std::vector<ColumnKind>& kinds, const Dialect& dialect) {
  if (is_row_of_column_numbers(cells)) return false;
  for (std::size_t i = first_own_column(dialect); i < kinds.size() && i < cells.size(); ++i) {
    if (kinds[i] != ColumnKind::text && kind_of(cells[i], dialect) == ColumnKind::text) return false;
  }
  return is_data_row(cells, kinds, dialect);
}

// A line drawn beneath the names: "|---|---|".
bool is_rule(std::string_view line) {
  return line.find("--") != std::string_view::npos &&
         line.find_first_not_of("-+=|: \t,;") == std::string_view::npos;
}

// The lines above the first row of a table.
class Head {
 public:
  Head(const TextSample& sample, const SniffedTable& table, TableLayout& layout)
      : sample_(sample), table_(table), layout_(layout) {
    kinds_ = column_kinds(sample.contents, table.dialect, table.width);
  }

  void read() {
    const std::size_t first_row = find_first_row();
    std::size_t end = 0;
    if (first_row == sample_.head.size()) {
      layout_.first_row_line = 1;
    } else {
      layout_.first_row_line = sample_.head[first_row].number;
      end = take_header(first_row);
    }
    const std::vector<std::string> units = std::move(units_);
    layout_.columns = name_columns(layout_.header, kinds_, layout_.remarks);
    if (table_.dialect.rows_are_stamped && !layout_.columns.empty()) layout_.columns.front().name = "stamp";
    for (std::size_t i = 0; i < units.size() && i < layout_.columns.size(); ++i) {
      if (!units[i].empty()) layout_.columns[i].unit = units[i];
    }
    if (first_row < sample_.head.size()) take_units_of_cells(sample_.head[first_row].text);
    for (std::size_t i = 0; i < end; ++i) take_line_above(sample_.head[i]);
    if (left_out_ > max_remarks_above) {
      layout_.remarks.push_back(std::to_string(left_out_ - max_remarks_above) +
                                " more lines of text above the table: left out");
    }
  }

 private:
  std::size_t find_first_row() const {
    Cells cells;
    for (std::size_t i = 0; i < sample_.head.size(); ++i) {
      if (is_comment(sample_.head[i].text)) continue;
      split_row(sample_.head[i].text, table_.dialect, cells);
      if (width_of(cells, table_.width) == table_.width && is_first_data_row(cells, kinds_, table_.dialect))
        return i;
    }
    return sample_.head.size();
  }

  // The cells of a line that can be the header; empty where it cannot.
  std::vector<std::string> header_cells(const Line& line) const {
    if (is_comment(line.text)) return comment_header(line.text, table_.dialect, table_.width);
    Cells cells;
    split_row(line.text, table_.dialect, cells);
    cells.resize(width_of(cells, table_.width));
    if (is_row_of_column_numbers(cells) && cells.size() == table_.width) return as_strings(cells);
    if (!is_header_row(cells, table_.dialect)) return {};
    std::vector<std::string> names = as_strings(cells);
    if (names.size() + 1 == table_.width && table_.width > 2)
      names.insert(rows_are_named() ? names.begin() : names.end(), std::string());
    while (names.size() > table_.width && drop_name_without_column(names)) {
    }
    return names.size() == table_.width ? names : std::vector<std::string>();
  }

  // R leaves out the name above the names of its rows, which are texts or numbers from 1 on; others that
  // above an index from 0.
  bool rows_are_named() const {
    if (kinds_.front() == ColumnKind::text) return true;
    std::size_t row = 0;
    Cells cells;
    for (std::size_t i = first_row_; i < sample_.head.size() && row < 3; ++i, ++row) {
      split_row(sample_.head[i].text, table_.dialect, cells);
      if (row == 0 && !cells.empty() && cells.front() == "1") return true;
      if (cells.empty() || cells.front() != std::to_string(row)) return false;
    }
    return row == 3;
  }

  // A note that the rows leave out ("Comment" of LabVIEW), and a version before the names ("v=1").
  // Whether there was one.
  static bool drop_name_without_column(std::vector<std::string>& names) {
    constexpr std::array notes{"",       "comment", "comments", "note",  "notes",
                               "remark", "remarks", "mark",     "event", "marker"};
    if (names.front().find('=') != std::string::npos) {
      names.erase(names.begin());
      return true;
    }
    if (std::ranges::find(notes, config::lower_case(names.back())) == notes.end()) return false;
    names.pop_back();
    return true;
  }

  // "0.05 sec" in the first row.
  void take_units_of_cells(std::string_view row) {
    Cells cells;
    split_row(row, table_.dialect, cells);
    for (std::size_t i = 0; i < cells.size() && i < layout_.columns.size(); ++i) {
      if (!layout_.columns[i].unit.empty() || layout_.columns[i].kind != ColumnKind::number) continue;
      if (const auto number = read_number_with_unit(cells[i], table_.dialect.decimal))
        layout_.columns[i].unit = number->unit;
    }
  }

  void say_that_a_name_is_missing(const Line& header) {
    Cells cells;
    split_row(header.text, table_.dialect, cells);
    if (cells.size() + 1 != table_.width || is_comment(header.text) || rows_are_named()) return;
    layout_.remarks.push_back("line " + std::to_string(header.number) + ": " + std::to_string(cells.size()) +
                              " names above " + std::to_string(table_.width) +
                              " columns: the last column has none");
  }

  // Returns the number of lines that stand above what belongs to the header.
  std::size_t take_header(std::size_t first_row) {
    if (first_row == 0) return 0;
    first_row_ = first_row;
    std::size_t at = first_row - 1;
    if (at > 0 && (is_rule(sample_.head[at].text) || trim(sample_.head[at].text).ends_with('['))) --at;
    layout_.header = header_cells(sample_.head[at]);
    if (layout_.header.empty()) return first_row;
    const std::vector<std::string> above = at > 0 ? header_cells(sample_.head[at - 1]) : layout_.header;
    if (at > 0 && !above.empty() && is_units_row(layout_.header)) {
      for (const std::string& unit : layout_.header) units_.push_back(bare_unit(unit));
      layout_.header = above;
      layout_.has_units_row = true;
      --at;
    } else {
      at = join_names_above(at);
    }
    layout_.header_is_comment = is_comment(sample_.head[at].text);
    say_that_a_name_is_missing(sample_.head[at]);
    return at;
  }

  // Rows of names above others that occur more than once, up to where each occurs once. Those of a motion
  // capture system begin with what they hold: "Name", and beside it "Type" and "ID", which tell no more.
  std::size_t join_names_above(std::size_t at) {
    constexpr std::size_t max_rows = 6;
    for (std::size_t row = 0; row < max_rows && at > 0; ++row) {
      Cells cells;
      split_row(sample_.head[at - 1].text, table_.dialect, cells);
      cells.resize(width_of(cells, table_.width));
      const auto label = std::ranges::find_if(cells, [](std::string_view cell) { return !cell.empty(); });
      const bool is_labelled = label != cells.end() && label - cells.begin() < 2;
      if (is_labelled && has_names_above(at) && (*label == "Type" || *label == "ID" || *label == "Parent")) {
        --at;
        continue;
      }
      std::vector<std::string> above = header_cells(sample_.head[at - 1]);
      if (above.empty()) break;
      if (is_labelled && *label == "Name") above[static_cast<std::size_t>(label - cells.begin())].clear();
      if (!join_upper_names(above, layout_.header)) break;
      --at;
    }
    return at;
  }

  // Whether names still occur more than once, so that the rows above are asked.
  bool has_names_above(std::size_t at) const {
    std::vector<std::string> names = layout_.header;
    return at > 1 && join_upper_names(std::vector<std::string>(names.size()), names);
  }

  void take_line_above(const Line& line) {
    const bool is_note = is_comment(line.text);
    const auto stamp = table_.dialect.rows_are_stamped ? stamp_prefix(line.text) : std::nullopt;
    const std::string_view bare = line.text.substr(stamp ? stamp->length : 0);
    const std::string_view text = is_note ? comment_text(bare) : trim(bare);
    if (text.empty() || take_frame_rate(text)) return;
    if (auto pair = key_and_value(text)) {
      layout_.metadata.push_back(*std::move(pair));
    } else if (is_note) {
      layout_.metadata.emplace_back("comment", std::string(text));
    } else if (!take_pair(bare) && ++left_out_ <= max_remarks_above) {
      layout_.remarks.push_back("line " + std::to_string(line.number) + ": '" + config::excerpt(text) +
                                "' above the table: left out");
    }
  }

  // Vicon's files begin with what they hold in a line of its own, and how many frames of it a second has in
  // the next.
  bool take_frame_rate(std::string_view text) {
    constexpr std::array contents{"Objects", "Segments", "Trajectories", "Joints", "Model Outputs"};
    text = trim(text.substr(0, text.find_last_not_of(",;\t ") + 1));
    const bool follows_contents =
        std::exchange(is_below_contents_, std::ranges::find(contents, text) != contents.end());
    if (is_below_contents_) return true;
    if (!follows_contents || !read_number(text, table_.dialect.decimal)) return false;
    layout_.metadata.emplace_back("frame rate", std::string(text));
    return true;
  }

  // "robot,Rover" above a wider table; several of these pairs in a line, with a number among the values.
  bool take_pair(std::string_view line) {
    Dialect dialect = table_.dialect;
    dialect.rows_are_stamped = false;
    Cells cells;
    split_row(line, dialect, cells);
    if (dialect.separator == ' ' || table_.width == 2) return false;
    cells.resize(width_of(cells, 2));
    const bool is_one = cells.size() == 2 && !cells[0].empty();
    if (!is_one && !are_pairs(cells)) return false;
    for (std::size_t i = 0; i + 1 < cells.size(); i += 2)
      layout_.metadata.emplace_back(std::string(cells[i]), std::string(cells[i + 1]));
    return true;
  }

  bool are_pairs(const Cells& cells) const {
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto kind = kind_of(cells[i], table_.dialect);
      if (i % 2 == 0 && kind != ColumnKind::text) return false;
      if (i % 2 == 1 && kind == ColumnKind::number) ++numbers;
    }
    return cells.size() >= 4 && cells.size() % 2 == 0 && numbers > 0;
  }

  static std::vector<std::string> as_strings(const Cells& cells) {
    std::vector<std::string> strings;
    for (const std::string_view cell : cells) strings.push_back(unescape_quotes(cell));
    return strings;
  }

  const TextSample& sample_;
  const SniffedTable& table_;
  TableLayout& layout_;
  std::vector<ColumnKind> kinds_;
  std::vector<std::string> units_;
  std::size_t first_row_ = 0;
  std::size_t left_out_ = 0;
  bool is_below_contents_ = false;
};

}  // namespace

TableLayout find_layout(const TextSample& sample, const SniffedTable& table) {
  TableLayout layout;
  Head(sample, table, layout).read();
  return layout;
}

std::vector<ColumnKind> column_kinds(const std::vector<std::string_view>& lines, const Dialect& dialect,
                                     std::size_t width) {
  std::vector<std::array<std::size_t, kind_count>> counts(width);
  Cells cells;
  for (const std::string_view line : lines) {
    split_row(line, dialect, cells);
    if (width_of(cells, width) != width) continue;
    for (std::size_t i = 0; i < width; ++i) {
      if (const auto kind = kind_of(cells[i], dialect)) ++counts[i].at(static_cast<std::size_t>(*kind));
    }
  }
  std::vector<ColumnKind> kinds(width, ColumnKind::number);
  for (std::size_t i = 0; i < width; ++i) {
    const auto last = counts[i].end() - 1;  // text
    const auto most = std::max_element(counts[i].begin(), last);
    std::size_t values = 0;
    for (auto count = counts[i].begin(); count != last; ++count) values += *count;
    kinds[i] = *last > values ? ColumnKind::text : static_cast<ColumnKind>(most - counts[i].begin());
  }
  return kinds;
}

bool is_header_row(const Cells& cells, const Dialect& dialect) {
  std::size_t names = 0;
  for (std::size_t i = first_own_column(dialect); i < cells.size(); ++i) {
    const auto kind = kind_of(cells[i], dialect);
    if (kind && *kind != ColumnKind::text) return false;
    if (kind) ++names;
  }
  return names > 0;
}

bool is_data_row(const Cells& cells, const std::vector<ColumnKind>& kinds, const Dialect& dialect) {
  std::size_t values = 0;
  std::size_t texts = 0;
  for (std::size_t i = first_own_column(dialect); i < kinds.size() && i < cells.size(); ++i) {
    const auto kind = kind_of(cells[i], dialect);
    if (kind && kinds[i] != ColumnKind::text) ++(*kind == ColumnKind::text ? texts : values);
  }
  return values > 0 && texts <= values;
}

}  // namespace wheelwright::import
