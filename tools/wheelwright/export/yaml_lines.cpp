#include "tools/wheelwright/export/yaml_lines.hpp"

#include <algorithm>

namespace wheelwright::tools {
namespace {

std::string with_point(std::string number) {
  if (number.find('.') == std::string::npos) number.insert(std::min(number.find('e'), number.size()), ".0");
  return number;
}

std::vector<std::string> levels_of(const YamlLine& line) {
  if (line.is_flat) return {line.key};
  const std::string& key = line.key;
  std::vector<std::string> levels;
  std::size_t begin = 0;
  for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', begin)) {
    levels.push_back(key.substr(begin, dot - begin));
    begin = dot + 1;
  }
  levels.push_back(key.substr(begin));
  return levels;
}

}  // namespace

std::vector<std::string> yaml_values(const PlacedNumber& number) {
  std::vector<std::string> values = values_of(number);
  if (number.word.empty()) std::ranges::transform(values, values.begin(), with_point);
  return values;
}

YamlLine yaml_line(const PlacedNumber& number) {
  const std::vector<std::string> values = yaml_values(number);
  std::string text = values.front();
  for (std::size_t i = 1; i < values.size(); ++i) text += ", " + values[i];
  if (values.size() > 1) text = "[" + text + "]";
  return {number.key, std::move(text), number.remark, false};
}

std::string yaml_lines(const std::vector<YamlLine>& lines, const std::string& indent, const std::string& step,
                       const std::string& line_break) {
  std::string text;
  std::vector<std::string> open;
  for (const YamlLine& line : lines) {
    const std::vector<std::string> levels = levels_of(line);
    const std::size_t above = levels.size() - 1;
    const auto end = levels.begin() + static_cast<std::ptrdiff_t>(above);
    const auto differs = std::mismatch(open.begin(), open.end(), levels.begin(), end).second;
    std::string margin = indent;
    for (auto level = levels.begin(); level != end; ++level) {
      if (level >= differs) text.append(margin).append(*level).append(":").append(line_break);
      margin += step;
    }
    open.assign(levels.begin(), end);
    text += margin + levels.back() + ": " + line.value;
    if (!line.remark.empty()) text.append("  ").append(yaml_remark_mark).append(" ").append(line.remark);
    text += line_break;
  }
  return text;
}

}  // namespace wheelwright::tools
