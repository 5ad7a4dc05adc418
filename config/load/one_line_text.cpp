#include "config/load/one_line_text.hpp"

#include <algorithm>

namespace wheelwright::config {
namespace {

std::string checked(const YamlReader& reader, std::string_view key, std::string text) {
  if (has_control_character(text)) {
    reader.fail(key, "holds a line break or another control character; give a name of one line");
  }
  return text;
}

}  // namespace

bool has_control_character(std::string_view text) {
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  };
  if (std::any_of(text.begin(), text.end(), is_control)) return true;
  // Those beyond ASCII, in UTF-8: U+0080 to U+009F.
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const auto next = static_cast<unsigned char>(text[i + 1]);
    if (text[i] == '\xc2' && next >= 0x80 && next < 0xa0) return true;
  }
  return false;
}

std::string one_line_text(YamlReader& reader, std::string_view key) {
  return checked(reader, key, reader.text(key));
}

std::string one_line_text(YamlReader& reader, std::string_view key, const std::string& default_value) {
  return checked(reader, key, reader.text(key, default_value));
}

}  // namespace wheelwright::config
