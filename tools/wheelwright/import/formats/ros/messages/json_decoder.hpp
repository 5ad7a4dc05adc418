// Messages that are JSON texts: their numbers by path, "pose.position.x", as MessageDecoder names them. An
// object of sec and nsec (or nanosec) is a time in seconds.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "tools/wheelwright/import/formats/ros/messages/row_table.hpp"

namespace wheelwright::import::ros {

class JsonDecoder {
 public:
  // The table is to outlive the decoder.
  explicit JsonDecoder(RowTable& table) : table_(table) {}

  // Fills the row of the table. What is wrong with a message is returned in one line; the row is clear then.
  std::optional<std::string> decode(std::string_view message);

 private:
  struct Walk;
  void set(const std::string& path, double value);

  RowTable& table_;
  std::unordered_map<std::string, std::size_t> channels_;
};

}  // namespace wheelwright::import::ros
