// The columns of a table of messages without names, as `ros2 topic echo --csv` prints it: the numbers and
// texts of a message from first to last, so that their order says which type it is.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wheelwright::import::ros {

// What stands in a column of a table, as far as a type can be recognised by it.
struct ColumnContent {
  std::span<const double> values;      // of numbers, one a row
  std::span<const std::string> texts;  // the different texts of a column of texts; empty of numbers
};

struct MessageColumns {
  std::string type;                // "nav_msgs/Odometry"; empty of a message whose header alone is known
  std::vector<std::string> names;  // of all columns: "header.stamp.sec", "pose.pose.position.x"
};

// The type whose header, texts and numbers stand so; of an unknown type with a header, its stamp and numbers
// from 1 for the rest. Nothing where the table does not begin with a header: seconds, nanoseconds, and a text
// for its frame, which may be empty if the type is known.
std::optional<MessageColumns> recognise_message(std::span<const ColumnContent> columns);

}  // namespace wheelwright::import::ros
