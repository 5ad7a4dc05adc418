// Which columns of a table are its commands and its wheels.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct Candidate {
  const Channel* channel;
  bool cumulative;  // its steps are the motion, as of counts; else its values are, as of speeds
};

struct Assignment {
  CommandKind kind = CommandKind::wheels;
  const Channel* command[2] = {nullptr, nullptr};
  Candidate wheel[2] = {};
  double nats = 0.0;
  double explained = 0.0;
  const Channel* reversed = nullptr;  // the wheel that counts backwards
};

// Fills in the command and the wheels that `mapping` lacks; adds a line with the evidence to `findings` for
// each.
void take_assignment(const Stream& stream, const Assignment& best, Mapping& mapping,
                     std::vector<std::string>& findings);

// "column 3", "'data(:,3)'".
std::string column_in_words(const Channel& channel);

}  // namespace wheelwright::import
