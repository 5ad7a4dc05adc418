#include "tools/wheelwright/export/c/c_fragment.hpp"

#include <algorithm>

namespace wheelwright::tools {

bool CFragment::has(std::string_view function) const {
  return text.find(std::string(name) + "_" + std::string(function) + "(") != std::string_view::npos;
}

std::string CFragment::remark(std::string_view heading) const {
  const std::string_view comment = text.substr(0, text.find("*/"));
  const auto at = comment.find(heading);
  if (at == std::string_view::npos) return "";
  std::string line;
  for (const char character : comment.substr(at + heading.size())) {
    const bool blank = character == ' ' || character == '\n';
    if (blank && (line.empty() || line.back() == ' ')) continue;
    line += blank ? ' ' : character;
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

const CFragment* find_c_fragment(std::string_view effect) {
  const auto fragments = c_fragments();
  const auto found = std::ranges::find(fragments, effect, &CFragment::name);
  return found == fragments.end() ? nullptr : &*found;
}

}  // namespace wheelwright::tools
