// A mapping of a YAML file, read strictly: each key is asked for by name, type, range and unit, and what was
// not asked for is an error that names the nearest right key. Every error says file, line and column.
//
//   YamlReader file = YamlReader::load("robot.yaml");
//   config.period_s = file.number("period_s", {0.005, 0.5, "s"}, config.period_s);  // optional
//   if (auto wheels = file.section("wheels")) {
//     ...
//     wheels->finish();
//   }
//   file.finish();
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wheelwright::config {

// What is wrong with a file, where, and what would be right, in one line: "robot.yaml:3:9: ...".
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The closed range of a number and the unit in which the file gives it.
struct Range {
  double minimum;
  double maximum;
  std::string_view unit = "";
};

class YamlReader {
 public:
  // Reads and parses a file, or throws ConfigError where it is missing, unreadable, no YAML, or no mapping.
  static YamlReader load(const std::filesystem::path& path);
  // The same from a text; `name` stands for the file in messages.
  static YamlReader parse(const std::string& text, const std::string& name);

  YamlReader(YamlReader&&) noexcept;
  YamlReader& operator=(YamlReader&&) noexcept;
  ~YamlReader();

  // Each of these reads one key. With a default the key is optional; without, a missing key is an error.
  double number(std::string_view key, Range range);
  double number(std::string_view key, Range range, double default_value);
  std::int64_t integer(std::string_view key, Range range);
  std::int64_t integer(std::string_view key, Range range, std::int64_t default_value);
  bool boolean(std::string_view key, bool default_value);
  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string default_value);
  // A file name, taken relative to the folder of this file; it must exist.
  std::filesystem::path existing_file(std::string_view key);
  std::vector<double> numbers(std::string_view key, Range range);
  // A list of rows of `columns` numbers each, e.g. [[0, 0], [1, 0]].
  std::vector<std::vector<double>> rows(std::string_view key, std::size_t columns, Range range);
  std::vector<std::string> texts(std::string_view key);

  // One of a closed set of words.
  template <typename Value>
  Value choice(std::string_view key, std::initializer_list<std::pair<std::string_view, Value>> words,
               Value default_value) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : words) names.push_back(name);
    const std::optional<std::size_t> at = choice_index(key, names);
    return at ? (words.begin() + *at)->second : default_value;
  }

  bool has(std::string_view key) const;
  // Whether the key is there and holds keys below it.
  bool has_section(std::string_view key) const;
  // A mapping below this one, or nothing where the key is absent.
  std::optional<YamlReader> section(std::string_view key);
  // A list of mappings below this one; empty where the key is absent.
  std::vector<YamlReader> sections(std::string_view key);

  // Throws ConfigError for the first key that nobody has asked for.
  void finish() const;

  // Throws ConfigError at the place of a key of this mapping, for checks that involve more than one value.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  struct Node;
  explicit YamlReader(std::unique_ptr<Node> node);
  std::optional<std::size_t> choice_index(std::string_view key, const std::vector<std::string_view>& names);
  std::unique_ptr<Node> node_;
};

// The candidate that a person most likely meant by `word`, or empty where none is near (edit distance).
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace wheelwright::config
