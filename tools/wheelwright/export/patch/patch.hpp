// Putting the numbers of a model into a file that somebody has already.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

// Which things of the file are meant; found where a name is empty.
struct PatchNames {
  std::string left_joint;
  std::string right_joint;
  std::string within;  // an SDF model, or a node of ROS
};

struct NumberChange {
  std::string place;  // "joint left_wheel frictionloss"
  std::size_t row = 0;
  std::optional<std::string> before;  // nothing where it was not there
  std::string after;
  std::string reason;  // why the file has no place for it; empty where it has one
  PlacedNumber number;
  std::string kept_within;  // the robot's own limit, where the file has a tighter one

  bool is_unsaid() const { return !reason.empty(); }
};

struct Patch {
  std::string text;
  std::vector<NumberChange> changes;
  std::vector<Unsaid> unsaid;  // effects that the format has no place for
};

// A file as it was read; its name stands in messages.
struct PatchedFile {
  std::string name;
  std::string text;
};

}  // namespace wheelwright::tools
