#include "daemon/recording/mcap/json_object.hpp"

#include "config/load/printable_text.hpp"

namespace wheelwright::mcap {

JsonObject& JsonObject::name(std::string_view key) {
  if (text_.back() != '{') text_ += ',';
  text_ += '"';
  text_ += key;
  text_ += "\":";
  return *this;
}

JsonObject& JsonObject::append(double value, int decimals) {
  std::array<char, 400> buffer{};
  if (!std::isfinite(value)) {
    text_ += "null";
    return *this;
  }
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals)
          .ptr;
  std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  digits = digits.substr(0, digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.remove_suffix(1);
  text_ += digits == "-0" ? "0" : digits;
  return *this;
}

JsonObject& JsonObject::whole(std::string_view key, std::int64_t value) {
  name(key);
  text_ += std::to_string(value);
  return *this;
}

JsonObject& JsonObject::text(std::string_view key, std::string_view value) {
  constexpr std::string_view digits = "0123456789abcdef";
  name(key);
  text_ += '"';
  std::string escaped;
  for (const char character : value) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      escaped += {'\\', character};
    } else if (code < 0x20) {
      escaped += {'\\', 'u', '0', '0', digits[code >> 4U], digits[code & 15U]};
    } else {
      escaped += character;
    }
  }
  text_ += config::printable_json(escaped);
  text_ += '"';
  return *this;
}

JsonObject& JsonObject::flag(std::string_view key, bool value) {
  name(key);
  text_ += value ? "true" : "false";
  return *this;
}

JsonObject& JsonObject::open(std::string_view key) {
  name(key);
  text_ += '{';
  return *this;
}

JsonObject& JsonObject::close() {
  text_ += '}';
  return *this;
}

JsonObject& JsonObject::time(std::string_view key, std::uint64_t time_ns) {
  constexpr std::uint64_t second_ns = 1'000'000'000;
  return open(key)
      .whole("sec", static_cast<std::int64_t>(time_ns / second_ns))
      .whole("nsec", static_cast<std::int64_t>(time_ns % second_ns))
      .close();
}

}  // namespace wheelwright::mcap
