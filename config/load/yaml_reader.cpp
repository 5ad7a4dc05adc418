#include "config/load/yaml_reader.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <unordered_set>

#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/yaml_bounds.hpp"

namespace wheelwright::config {
namespace {

std::string place(const std::string& file, const YAML::Mark& mark) {
  if (mark.is_null()) return file;
  return file + ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1);
}

std::string as_written(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string kind(const YAML::Node& node) {
  if (node.IsScalar()) return "'" + excerpt(node.Scalar()) + "'";
  if (node.IsSequence()) return "a list";
  if (node.IsMap()) return "a mapping";
  return "nothing";
}

}  // namespace

struct YamlReader::Node {
  std::string file;
  YAML::Node yaml;
  std::vector<std::string> asked;

  [[noreturn]] void fail_at(const YAML::Mark& mark, const std::string& what) const {
    throw ConfigError(place(file, mark) + ": " + what);
  }

  YAML::Node find(std::string_view key) {
    asked.emplace_back(key);
    const YAML::Node found = std::as_const(yaml)[std::string(key)];
    return found.IsDefined() ? found : YAML::Node(YAML::NodeType::Undefined);
  }

  YAML::Node require(std::string_view key) {
    const YAML::Node found = find(key);
    if (!found.IsDefined() || found.IsNull()) {
      fail_at(yaml.Mark(), "'" + std::string(key) + "' is missing here");
    }
    return found;
  }

  double as_number(const YAML::Node& value, std::string_view key, const Range& range) const {
    const std::string name = "'" + std::string(key) + "'";
    const std::string wanted = "a number from " + as_written(range.minimum) + " to " +
                               as_written(range.maximum) +
                               (range.unit.empty() ? "" : " " + std::string(range.unit));
    double number = 0.0;
    if (!value.IsScalar() || !YAML::convert<double>::decode(value, number) || !std::isfinite(number)) {
      fail_at(value.Mark(), name + " is " + kind(value) + ", but must be " + wanted);
    }
    if (number < range.minimum || number > range.maximum) {
      fail_at(value.Mark(), name + " is " + excerpt(value.Scalar()) + ", but must be " + wanted);
    }
    return number;
  }

  void check_no_duplicates() const {
    std::unordered_set<std::string_view> seen;
    for (const auto& entry : yaml) {
      if (!entry.first.IsScalar()) fail_at(entry.first.Mark(), "a key must be a word");
      const std::string& key = entry.first.Scalar();
      if (!seen.insert(key).second) {
        fail_at(entry.first.Mark(), "'" + excerpt(key) + "' occurs here a second time; keep one");
      }
    }
  }

  static YamlReader reader(const std::string& file, const YAML::Node& yaml) {
    auto node = std::make_unique<Node>(Node{file, yaml, {}});
    if (!yaml.IsMap()) {
      node->fail_at(yaml.Mark(), "expected 'key: value' lines, found " + kind(yaml));
    }
    node->check_no_duplicates();
    return YamlReader(std::move(node));
  }
};

YamlReader::YamlReader(std::unique_ptr<Node> node) : node_(std::move(node)) {}
YamlReader::YamlReader(YamlReader&&) noexcept = default;
YamlReader& YamlReader::operator=(YamlReader&&) noexcept = default;
YamlReader::~YamlReader() = default;

YamlReader YamlReader::load(const std::filesystem::path& path) {
  return parse(read_text_or_throw<ConfigError>(path, yaml_file), path.string());
}

YamlReader YamlReader::parse(const std::string& text, const std::string& name) {
  YAML::Node yaml;
  try {
    check_yaml_bounds(text);
    yaml = YAML::Load(text);
  } catch (const YamlRefused& error) {
    throw ConfigError(place(name, error.mark) + ": " + error.msg);
  } catch (const YAML::Exception& error) {
    throw ConfigError(place(name, error.mark) + ": not valid YAML: " + error.msg);
  }
  return Node::reader(name, yaml);
}

double YamlReader::number(std::string_view key, Range range) {
  return node_->as_number(node_->require(key), key, range);
}

double YamlReader::number(std::string_view key, Range range, double default_value) {
  const YAML::Node value = node_->find(key);
  return value.IsDefined() ? node_->as_number(value, key, range) : default_value;
}

std::int64_t YamlReader::integer(std::string_view key, Range range) {
  const YAML::Node value = node_->require(key);
  const double number = node_->as_number(value, key, range);
  if (number != std::floor(number)) {
    node_->fail_at(value.Mark(), "'" + std::string(key) + "' is " + excerpt(value.Scalar()) +
                                     ", but must be a whole number");
  }
  return static_cast<std::int64_t>(number);
}

std::int64_t YamlReader::integer(std::string_view key, Range range, std::int64_t default_value) {
  if (node_->find(key).IsDefined()) return integer(key, range);
  return default_value;
}

bool YamlReader::boolean(std::string_view key, bool default_value) {
  const YAML::Node value = node_->find(key);
  if (!value.IsDefined()) return default_value;
  bool result = default_value;
  if (!value.IsScalar() || !YAML::convert<bool>::decode(value, result)) {
    node_->fail_at(value.Mark(),
                   "'" + std::string(key) + "' is " + kind(value) + ", but must be true or false");
  }
  return result;
}

std::string YamlReader::text(std::string_view key) {
  const YAML::Node value = node_->require(key);
  if (!value.IsScalar()) {
    node_->fail_at(value.Mark(), "'" + std::string(key) + "' is " + kind(value) + ", but must be a text");
  }
  return value.Scalar();
}

std::string YamlReader::text(std::string_view key, std::string default_value) {
  if (node_->find(key).IsDefined()) return text(key);
  return default_value;
}

std::filesystem::path YamlReader::existing_file(std::string_view key) {
  const YAML::Node value = node_->require(key);
  const std::filesystem::path named = text(key);
  if (named.empty())
    node_->fail_at(value.Mark(), "'" + std::string(key) + "' is empty, but must name a file");
  std::filesystem::path path =
      named.is_absolute() ? named : std::filesystem::path(node_->file).parent_path() / named;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    node_->fail_at(value.Mark(), "'" + std::string(key) + "' names " + path.string() + ", which is no file");
  }
  return path;
}

std::vector<double> YamlReader::numbers(std::string_view key, Range range) {
  const YAML::Node list = node_->require(key);
  if (!list.IsSequence()) {
    node_->fail_at(list.Mark(),
                   "'" + std::string(key) + "' is " + kind(list) + ", but must be a list of numbers");
  }
  std::vector<double> result;
  result.reserve(list.size());
  for (const auto& value : list) result.push_back(node_->as_number(value, key, range));
  return result;
}

std::vector<std::vector<double>> YamlReader::rows(std::string_view key, std::size_t columns, Range range) {
  const YAML::Node list = node_->require(key);
  const std::string wanted = "a list of rows of " + std::to_string(columns) + " numbers each";
  if (!list.IsSequence()) {
    node_->fail_at(list.Mark(), "'" + std::string(key) + "' is " + kind(list) + ", but must be " + wanted);
  }
  std::vector<std::vector<double>> result;
  for (const auto& row : list) {
    if (!row.IsSequence() || row.size() != columns) {
      node_->fail_at(row.Mark(), "'" + std::string(key) + "' holds " + kind(row) + ", but must be " + wanted);
    }
    auto& values = result.emplace_back();
    for (const auto& value : row) values.push_back(node_->as_number(value, key, range));
  }
  return result;
}

std::vector<std::string> YamlReader::texts(std::string_view key) {
  const YAML::Node list = node_->find(key);
  std::vector<std::string> result;
  if (!list.IsDefined()) return result;
  if (!list.IsSequence()) {
    node_->fail_at(list.Mark(), "'" + std::string(key) + "' is " + kind(list) + ", but must be a list");
  }
  for (const auto& value : list) {
    if (!value.IsScalar()) node_->fail_at(value.Mark(), "'" + std::string(key) + "' must hold words");
    result.push_back(value.Scalar());
  }
  return result;
}

std::optional<std::size_t> YamlReader::choice_index(std::string_view key,
                                                    const std::vector<std::string_view>& names) {
  const YAML::Node value = node_->find(key);
  if (!value.IsDefined()) return std::nullopt;
  std::string wanted;
  for (const auto name : names) wanted += (wanted.empty() ? "" : ", ") + std::string(name);
  if (value.IsScalar()) {
    const auto at = std::find(names.begin(), names.end(), value.Scalar());
    if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  }
  node_->fail_at(value.Mark(),
                 "'" + std::string(key) + "' is " + kind(value) + ", but must be one of: " + wanted);
}

bool YamlReader::has(std::string_view key) const {
  return std::as_const(node_->yaml)[std::string(key)].IsDefined();
}

bool YamlReader::has_section(std::string_view key) const {
  const YAML::Node value = std::as_const(node_->yaml)[std::string(key)];
  return value.IsDefined() && value.IsMap();
}

std::optional<YamlReader> YamlReader::section(std::string_view key) {
  const YAML::Node value = node_->find(key);
  if (!value.IsDefined()) return std::nullopt;
  if (!value.IsMap()) {
    node_->fail_at(value.Mark(),
                   "'" + std::string(key) + "' is " + kind(value) + ", but must hold keys below it");
  }
  return Node::reader(node_->file, value);
}

std::vector<YamlReader> YamlReader::sections(std::string_view key) {
  const YAML::Node list = node_->find(key);
  std::vector<YamlReader> result;
  if (!list.IsDefined()) return result;
  if (!list.IsSequence()) {
    node_->fail_at(list.Mark(), "'" + std::string(key) + "' is " + kind(list) + ", but must be a list");
  }
  for (const auto& entry : list) result.push_back(Node::reader(node_->file, entry));
  return result;
}

void YamlReader::finish() const {
  for (const auto& entry : node_->yaml) {
    const std::string& key = entry.first.Scalar();
    const auto& asked = node_->asked;
    if (std::find(asked.begin(), asked.end(), key) != asked.end()) continue;
    const std::string near = nearest_word(key, asked);
    std::string known;
    for (auto name = asked.begin(); name != asked.end(); ++name) {
      if (std::find(asked.begin(), name, *name) == name) known += (known.empty() ? "" : ", ") + *name;
    }
    node_->fail_at(entry.first.Mark(),
                   "unknown key '" + excerpt(key) + "'; " +
                       (near.empty() ? "known here: " + known : "did you mean '" + near + "'?"));
  }
}

void YamlReader::fail(std::string_view key, const std::string& what) const {
  const YAML::Node value = std::as_const(node_->yaml)[std::string(key)];
  node_->fail_at(value.IsDefined() ? value.Mark() : node_->yaml.Mark(), "'" + std::string(key) + "' " + what);
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 100;
  std::string best;
  if (word.size() > longest_word) return best;
  std::size_t best_distance = std::max<std::size_t>(3, word.size() / 2) + 1;
  for (const auto& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i + 1;
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const std::size_t substituted = diagonal + (word[i] == candidate[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({substituted, diagonal + 1, row[j] + 1});
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace wheelwright::config
