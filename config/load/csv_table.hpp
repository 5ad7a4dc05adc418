// Any CSV of this project as a table: drive logs, pose logs, simulated motion, the truth of a simulated
// robot.
//
// Lines that start with '#' above the header row hold `key: value` metadata. What the columns mean is the
// caller's business; where a drive log is wanted, load_drive_log() says more about what is wrong with it.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::config {

class CsvTable {
 public:
  // Throws LogError where the file cannot be read, has no header row or no rows, a row has another number of
  // fields than the header, or the last one was cut short.
  static CsvTable load(const std::filesystem::path& path);
  // The same from a text; `name` stands for the file in messages.
  static CsvTable parse(std::string text, std::string name);

  const std::string& name() const { return name_; }
  // The value of a metadata key; empty where it is absent.
  const std::string& metadata(const std::string& key) const;
  const std::map<std::string, std::string>& all_metadata() const { return metadata_; }

  std::size_t rows() const { return columns_.empty() ? 0 : fields_.size() / columns_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }
  std::optional<std::size_t> find(std::string_view column) const;
  bool has(std::string_view column) const { return find(column).has_value(); }

  // A field as it stands there, without blanks around it.
  std::string_view text(std::size_t row, std::size_t column) const {
    return fields_[row * columns_.size() + column];
  }
  // A field as a number; nothing where it is empty. Throws LogError where it is something else, or larger
  // than 1e12 in size.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  // A whole column; not-a-number where a field is empty. Throws LogError where there is no such column or a
  // field is no number.
  std::vector<double> numbers(std::string_view column) const;

 private:
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;
  void take_line(std::string_view line, std::size_t number, bool is_open_ended);

  std::unique_ptr<const std::string> text_;  // that the fields look into
  std::string name_;
  std::map<std::string, std::string> metadata_;
  std::vector<std::string> columns_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> lines_;  // of each row in the file
};

}  // namespace wheelwright::config
