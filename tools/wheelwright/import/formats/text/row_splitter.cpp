#include "tools/wheelwright/import/formats/text/row_splitter.hpp"

#include <utility>

#include "tools/wheelwright/import/formats/text/line_cursor.hpp"

namespace wheelwright::import {
namespace {

bool is_blank(char character) {
  return character == ' ' || character == '\t';
}

std::string_view strip_blanks(std::string_view cell) {
  while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
  while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
  return cell;
}

std::string_view strip_quotes(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
  return strip_blanks(cell.substr(1, cell.size() - 2));
}

// The end of the quoted cell that begins a text: past the quote that closes it.
std::size_t quoted_end(std::string_view text) {
  std::size_t at = 1;
  while (at < text.size()) {
    if (text[at] != '"') {
      ++at;
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      at += 2;
    } else {
      return at + 1;
    }
  }
  return text.size();
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  std::size_t at = 0;
  while (cells.size() <= max_columns) {
    while (at < line.size() && is_blank(line[at])) ++at;
    if (at == line.size()) return;
    std::size_t end = at;
    if (line[at] == '"') end += quoted_end(line.substr(at));
    while (end < line.size() && !is_blank(line[end])) ++end;
    cells.push_back(strip_quotes(line.substr(at, end - at)));
    at = end;
  }
}

void split_at(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  const bool has_quotes = line.find('"') != std::string_view::npos;
  std::size_t at = 0;
  while (cells.size() <= max_columns) {
    std::size_t end = at;
    if (has_quotes) {
      while (end < line.size() && is_blank(line[end]) && line[end] != separator) ++end;
      if (end < line.size() && line[end] == '"') end += quoted_end(line.substr(end));
    }
    while (end < line.size() && line[end] != separator) ++end;
    const std::string_view cell = strip_blanks(line.substr(at, end - at));
    cells.push_back(has_quotes ? strip_quotes(cell) : cell);
    if (end == line.size()) return;
    at = end + 1;
  }
}

// "[1, 2, 3]" and "(1, 2, 3),": a list or a tuple that was printed.
std::string_view without_brackets(std::string_view line) {
  std::string_view row = trim(line);
  if (row.ends_with(',')) row.remove_suffix(1);
  for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
    if (row.size() < 2 || row.front() != open || row.back() != close) continue;
    const std::string_view inside = row.substr(1, row.size() - 2);
    if (inside.find(open) == std::string_view::npos && inside.find(close) == std::string_view::npos)
      return inside;
  }
  return line;
}

}  // namespace

void split_row(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& cells) {
  cells.clear();
  if (dialect.rows_are_stamped) {
    const auto prefix = stamp_prefix(line);
    cells.push_back(prefix ? prefix->stamp : std::string_view{});
    if (prefix) line.remove_prefix(prefix->length);
  }
  if (dialect.rows_are_quoted) {
    line = trim(line);
    if (line.starts_with('"')) line.remove_prefix(1);
    if (line.ends_with('"')) line.remove_suffix(1);
  }
  if (dialect.separator != ';') {  // the end of a row in a script of MATLAB
    while (!line.empty() && (is_blank(line.back()) || line.back() == ';')) line.remove_suffix(1);
  }
  line = without_brackets(line);
  if (dialect.separator == ' ') {
    split_at_blanks(line, cells);
  } else if (dialect.separator == '\0') {
    cells.push_back(strip_quotes(strip_blanks(line)));
  } else {
    split_at(line, dialect.separator, cells);
  }
}

std::string unescape_quotes(std::string_view cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') ++i;
  }
  return text;
}

bool is_comment(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

std::string_view comment_text(std::string_view line) {
  line = trim(line);
  while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '/'))
    line.remove_prefix(1);
  return trim(line);
}

}  // namespace wheelwright::import
