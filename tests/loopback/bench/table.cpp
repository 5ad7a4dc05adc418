#include "tests/loopback/bench/table.hpp"

#include <fstream>
#include <stdexcept>

namespace wheelwright::bench {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t from = 0;
  while (true) {
    const std::size_t comma = line.find(',', from);
    fields.push_back(line.substr(from, comma - from));
    if (comma == std::string::npos) return fields;
    from = comma + 1;
  }
}

}  // namespace

Table Table::load(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": cannot be read");
  Table table;
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) {
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos) table.metadata_[line.substr(2, colon - 2)] = line.substr(colon + 2);
      continue;
    }
    const auto fields = split(line);
    if (table.columns_.empty()) {
      for (const auto& name : fields) table.columns_.emplace(name, table.columns_.size());
      continue;
    }
    if (fields.size() != table.columns_.size()) {
      throw std::runtime_error(path.string() + ": a row of " + std::to_string(fields.size()) +
                               " fields: " + line);
    }
    table.fields_.push_back(fields);
  }
  return table;
}

const std::string& Table::word(std::size_t row, const std::string& column) const {
  return fields_.at(row).at(columns_.at(column));
}

double Table::number(std::size_t row, const std::string& column) const {
  return std::stod(word(row, column));
}

}  // namespace wheelwright::bench
