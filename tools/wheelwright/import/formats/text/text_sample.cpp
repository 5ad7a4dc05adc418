#include "tools/wheelwright/import/formats/text/text_sample.hpp"

#include <algorithm>

#include "tools/wheelwright/import/formats/text/row_splitter.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t head_lines = 300;
constexpr std::size_t lines_of_a_place = 60;
constexpr std::size_t places = 6;
constexpr std::size_t max_line_bytes = 64U << 10U;  // of a line that is looked at

void add_place(std::string_view text, std::size_t from, TextSample& sample) {
  const auto line_break = text.find_first_of("\r\n", from);
  if (line_break == std::string_view::npos) return;
  LineCursor cursor(text.substr(line_break));
  Line line;
  for (std::size_t count = 0; count < lines_of_a_place && cursor.next_filled(line); ++count) {
    if (!is_comment(line.text) && !line.is_open_ended)
      sample.contents.push_back(line.text.substr(0, max_line_bytes));
  }
}

}  // namespace

TextSample take_sample(std::string_view text) {
  TextSample sample;
  LineCursor cursor(text);
  Line line;
  while (sample.head.size() < head_lines && cursor.next_filled(line)) {
    line.text = line.text.substr(0, max_line_bytes);
    sample.head.push_back(line);
    const bool is_cut = line.is_open_ended && sample.contents.size() > 1;
    if (!is_comment(line.text) && !is_cut) sample.contents.push_back(line.text);
  }
  const std::size_t seen = cursor.offset();
  for (std::size_t place = 1; place <= places && seen < text.size(); ++place) {
    const std::size_t from = seen + (text.size() - seen) / (places + 1) * place;
    add_place(text, from, sample);
  }
  return sample;
}

}  // namespace wheelwright::import
