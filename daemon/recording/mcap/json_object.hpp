// JSON objects as text, built from left to right: fast enough for each tick of a run.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace wheelwright::mcap {

class JsonObject {
 public:
  // Begins again; the memory stays.
  JsonObject& begin() {
    text_.assign("{");
    return *this;
  }
  // Numbers have six decimals at most (micrometres, microvolts), those of a `fine` field twelve. What is not
  // finite is null.
  JsonObject& number(std::string_view key, double value) { return name(key).append(value, 6); }
  JsonObject& fine(std::string_view key, double value) { return name(key).append(value, 12); }
  JsonObject& whole(std::string_view key, std::int64_t value);
  JsonObject& text(std::string_view key, std::string_view value);
  JsonObject& flag(std::string_view key, bool value);
  JsonObject& open(std::string_view key);  // an object inside
  JsonObject& close();
  JsonObject& time(std::string_view key, std::uint64_t time_ns);  // {"sec": .., "nsec": ..}
  template <typename Numbers>
  JsonObject& array(std::string_view key, const Numbers& numbers);

  // The whole object.
  const std::string& end() {
    text_ += '}';
    return text_;
  }

 private:
  JsonObject& name(std::string_view key);
  JsonObject& append(double value, int decimals);

  std::string text_;
};

template <typename Numbers>
JsonObject& JsonObject::array(std::string_view key, const Numbers& numbers) {
  name(key);
  char separator = '[';
  for (const auto value : numbers) {
    text_ += separator;
    append(static_cast<double>(value), 12);
    separator = ',';
  }
  text_ += ']';
  return *this;
}

}  // namespace wheelwright::mcap
