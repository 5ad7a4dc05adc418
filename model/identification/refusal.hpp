// Why data cannot give what was asked of them.
#pragma once

#include <string>

namespace wheelwright {

// One line for a person: what is missing in the data, and how to get it.
struct Refusal {
  std::string reason;
};

}  // namespace wheelwright
