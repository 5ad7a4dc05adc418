// The sensor loop's wake-up lateness as a histogram in a text file, to be laid beside that of other programs.
#pragma once

#include <string>

#include "drivers/roomba/session.hpp"

namespace wheelwright::daemon {

// Lines `# key: value`, then one line per filled bin: upper edge in microseconds, and count.
std::string lateness_text(const roomba::Session& session, double period_s);

}  // namespace wheelwright::daemon
