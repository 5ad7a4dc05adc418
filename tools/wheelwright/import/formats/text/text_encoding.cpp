#include "tools/wheelwright/import/formats/text/text_encoding.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "config/load/printable_text.hpp"

namespace wheelwright::import {
namespace {

enum class Encoding { utf8, utf8_with_mark, utf16_little, utf16_big };

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
constexpr std::size_t examined_bytes = 4096;

std::uint8_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

// Latin text in UTF-16 has a zero in nearly every second byte.
Encoding guess_without_mark(std::string_view head) {
  std::size_t zeros_at_even = 0;
  std::size_t zeros_at_odd = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (head[i] == '\0') ++(i % 2 == 0 ? zeros_at_even : zeros_at_odd);
  }
  const std::size_t characters = head.size() / 2;
  const std::size_t many = characters - characters / 4;
  const std::size_t few = characters / 20;
  if (characters >= 2 && zeros_at_odd >= many && zeros_at_even <= few) return Encoding::utf16_little;
  if (characters >= 2 && zeros_at_even >= many && zeros_at_odd <= few) return Encoding::utf16_big;
  return Encoding::utf8;
}

Encoding encoding_of(std::string_view bytes) {
  if (bytes.starts_with(utf8_mark)) return Encoding::utf8_with_mark;
  if (bytes.starts_with("\xff\xfe")) return Encoding::utf16_little;
  if (bytes.starts_with("\xfe\xff")) return Encoding::utf16_big;
  return guess_without_mark(bytes.substr(0, examined_bytes));
}

void append_utf8(std::string& text, char32_t code) {
  const auto put = [&text](char32_t byte) { text += static_cast<char>(static_cast<std::uint8_t>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0U | (code >> 6U));
    put(0x80U | (code & 0x3fU));
  } else if (code < 0x10000) {
    put(0xe0U | (code >> 12U));
    put(0x80U | ((code >> 6U) & 0x3fU));
    put(0x80U | (code & 0x3fU));
  } else {
    put(0xf0U | (code >> 18U));
    put(0x80U | ((code >> 12U) & 0x3fU));
    put(0x80U | ((code >> 6U) & 0x3fU));
    put(0x80U | (code & 0x3fU));
  }
}

bool is_high_surrogate(char32_t unit) {
  return unit >= 0xd800 && unit < 0xdc00;
}
bool is_low_surrogate(char32_t unit) {
  return unit >= 0xdc00 && unit < 0xe000;
}

std::string from_utf16(std::string_view bytes, bool is_big) {
  const auto unit_at = [&](std::size_t at) -> char32_t {
    const std::uint32_t first = byte_at(bytes, at);
    const std::uint32_t second = byte_at(bytes, at + 1);
    return is_big ? first << 8U | second : second << 8U | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    char32_t code = unit_at(at);
    if (at == 0 && code == 0xfeff) continue;
    if (is_high_surrogate(code) && at + 3 < bytes.size() && is_low_surrogate(unit_at(at + 2))) {
      code = 0x10000 + ((code - 0xd800) << 10U) + (unit_at(at + 2) - 0xdc00);
      at += 2;
    } else if (is_high_surrogate(code) || is_low_surrogate(code)) {
      code = 0xfffd;
    }
    append_utf8(text, code);
  }
  return text;
}

bool is_ascii(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return static_cast<std::uint8_t>(c) < 0x80; });
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = config::utf8_length(bytes.substr(at));
    if (length == 0) append_utf8(text, byte_at(bytes, at));
    if (length > 0) text += bytes.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return text;
}

void drop_zeros_at_end(DecodedText& decoded) {
  const auto last = decoded.text.find_last_not_of('\0');
  const std::size_t kept = last == std::string::npos ? 0 : last + 1;
  const std::size_t zeros = decoded.text.size() - kept;
  if (zeros == 0) return;
  decoded.text.resize(kept);
  decoded.remarks.push_back(std::to_string(zeros) +
                            " zero bytes at the end of the file, as a power cut leaves them: left out");
}

bool is_stray(char character) {
  const auto code = static_cast<std::uint8_t>(character);
  return code == 0x7f || (code < 0x20 && (code < 0x08 || code > 0x0d) && code != 0x1b);
}

// "\x1b[0;32m", which sets the colour of a terminal.
void drop_colours(std::string& text) {
  constexpr std::string_view begin = "\x1b[";
  std::size_t end = 0;
  std::size_t kept = text.find(begin);
  if (kept == std::string::npos) return;
  for (std::size_t at = kept; at < text.size(); at = end) {
    if (std::string_view(text).substr(at).starts_with(begin)) {
      at = std::min(text.find_first_not_of("0123456789;", at + begin.size()), text.size() - 1) + 1;
    }
    end = std::min(text.find(begin, at), text.size());
    std::copy(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(end),
              text.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += end - at;
  }
  text.resize(kept);
}

}  // namespace

DecodedText decode_text(std::string bytes) {
  DecodedText decoded;
  switch (encoding_of(bytes)) {
    case Encoding::utf16_little:
      decoded.text = from_utf16(bytes, false);
      decoded.encoding = "UTF-16 LE";
      break;
    case Encoding::utf16_big:
      decoded.text = from_utf16(bytes, true);
      decoded.encoding = "UTF-16 BE";
      break;
    case Encoding::utf8_with_mark:
      bytes.erase(0, utf8_mark.size());
      decoded.encoding = "UTF-8 with a byte order mark";
      [[fallthrough]];
    case Encoding::utf8:
      decoded.text = std::move(bytes);
      break;
  }
  if (!is_ascii(decoded.text) && !config::is_utf8(decoded.text)) {
    decoded.text = from_latin1(decoded.text);
    decoded.encoding = "Latin-1";
  }
  drop_colours(decoded.text);
  drop_zeros_at_end(decoded);
  return decoded;
}

bool is_text(std::string_view head) {
  const Encoding encoding = encoding_of(head);
  if (encoding == Encoding::utf16_little || encoding == Encoding::utf16_big) return true;
  const auto last = head.find_last_not_of('\0');
  if (last == std::string_view::npos) return false;
  const std::string_view content = head.substr(0, last + 1);
  const auto stray = static_cast<std::size_t>(std::ranges::count_if(content, is_stray));
  return stray * 20 <= content.size();
}

}  // namespace wheelwright::import
