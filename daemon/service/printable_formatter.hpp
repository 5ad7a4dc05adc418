// Messages on a terminal or in the journal of a supervisor: whatever text of others they quote, in one line
// of printable characters.
#pragma once

#include <spdlog/formatter.h>

#include <memory>
#include <string>

namespace wheelwright::daemon {

// As spdlog's own formatter of this pattern, of a printable message.
std::unique_ptr<spdlog::formatter> make_printable_formatter(const std::string& pattern);

}  // namespace wheelwright::daemon
