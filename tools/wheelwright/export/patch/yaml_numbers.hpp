// Numbers into the values of a YAML file, each with a comment at the end of its line.
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/export/patch/patch.hpp"
#include "tools/wheelwright/export/patch/text_edits.hpp"
#include "tools/wheelwright/export/yaml_lines.hpp"

namespace wheelwright::tools {

class YamlNumbers {
 public:
  // Throws UsageError with file and row where the text is no YAML, or none that files here may be.
  explicit YamlNumbers(const PatchedFile& file);

  const YAML::Node& root() const { return root_; }

  // Ends with one line: file, row, and what is wrong.
  [[noreturn]] void fail(const YAML::Node& at, const std::string& what) const;
  [[noreturn]] void fail(const std::string& what) const;
  std::size_t row(const YAML::Node& node) const;

  // Each at its key below `parameters`; what is not there is added. `thing` names their owner.
  void set(const YAML::Node& parameters, const std::string& thing, const std::vector<PlacedNumber>& numbers);

  // Numbers that this file has no place for.
  void leave(const std::string& thing, const std::vector<PlacedNumber>& numbers, const std::string& reason);

  std::string text() const;
  const std::vector<NumberChange>& changes() const { return changes_; }

 private:
  // The mapping that a key is in as far as the file has its levels, and the rest of the key.
  struct Place {
    YAML::Node mapping;
    std::string rest;
    YAML::Node value;  // undefined where the key is not there
  };
  struct Addition {
    YAML::Node mapping;
    std::vector<YamlLine> lines;
  };

  Place find(const YAML::Node& parameters, const std::string& key) const;
  YAML::Node child(const YAML::Node& mapping, const std::string& key) const;
  std::size_t offset_of(const YAML::Node& scalar) const;
  std::string set_scalar(const YAML::Node& scalar, const std::string& value, bool is_limit);
  void set_value(const std::string& thing, const YAML::Node& node, const PlacedNumber& number);
  void add(std::vector<Addition>& additions, const Place& place, const PlacedNumber& number);
  void insert(const Addition& addition, std::size_t behind);
  void put_remarks(TextEdits& edits) const;

  std::string name_;
  std::string text_;
  YAML::Node root_;
  TextEdits edits_;
  std::map<std::size_t, std::vector<std::pair<std::string, std::string>>> remarks_;  // by a line's begin
  std::vector<NumberChange> changes_;
};

}  // namespace wheelwright::tools
