// The `wheelwright` command as tests call it.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tools/wheelwright/common/command_line.hpp"

namespace wheelwright::test {

struct Outcome {
  tools::ExitStatus status;
  std::string out;
  std::string err;
};

inline Outcome wheelwright_command(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const tools::ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, out.str(), err.str()};
}

inline bool is_one_line(const std::string& text) {
  return !text.empty() && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

}  // namespace wheelwright::test
