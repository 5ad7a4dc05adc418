// A log as the tests read it: rows of named columns, numbers or words.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wheelwright::bench {

class Table {
 public:
  // Reads a CSV file with `# key: value` lines before its header row. Throws std::runtime_error where a row
  // has more or fewer fields than the header.
  static Table load(const std::filesystem::path& path);

  std::size_t rows() const { return fields_.size(); }
  const std::string& word(std::size_t row, const std::string& column) const;
  bool empty(std::size_t row, const std::string& column) const { return word(row, column).empty(); }
  double number(std::size_t row, const std::string& column) const;
  const std::string& metadata(const std::string& key) const { return metadata_.at(key); }

 private:
  std::map<std::string, std::string> metadata_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> fields_;
};

}  // namespace wheelwright::bench
