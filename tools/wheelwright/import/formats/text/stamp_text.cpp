#include "tools/wheelwright/import/formats/text/stamp_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace wheelwright::import {
namespace {

// Where the comma stands in a line that holds "00:00:00,000" and then a blank or a bracket.
std::optional<std::size_t> comma_of_milliseconds(std::string_view line) {
  constexpr std::string_view form = "00:00:00,000";
  for (std::size_t at = 0; at + form.size() < line.size(); ++at) {
    std::size_t k = 0;
    while (k < form.size() && (form[k] == '0' ? std::isdigit(static_cast<unsigned char>(line[at + k])) != 0
                                              : line[at + k] == form[k]))
      ++k;
    const char behind = line[at + form.size()];
    if (k == form.size() && (behind == ' ' || behind == ']' || behind == '\t')) return at + form.find(',');
  }
  return std::nullopt;
}

}  // namespace

void point_milliseconds(std::string& text) {
  constexpr double most = 0.5;
  constexpr double enough_lines = 200.0;  // without one: it is no such log
  std::vector<std::size_t> commas;
  double lines = 0.0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    if (!line.empty()) lines += 1.0;
    if (const auto comma = comma_of_milliseconds(line)) commas.push_back(begin + *comma);
    if (commas.empty() && lines > enough_lines) return;
    begin = end + 1;
  }
  if (static_cast<double>(commas.size()) <= most * lines) return;
  for (const std::size_t comma : commas) text[comma] = '.';
}

}  // namespace wheelwright::import
