// The guardian's own process (daemon/guardian/guardian_handle.hpp): what the child does after the fork.
#pragma once

#include "daemon/guardian/guardian_handle.hpp"

namespace wheelwright::daemon {

// Messages on the socket, one byte each.
enum class GuardianOrder : char {
  adopt = 'a',    // the port comes along as a descriptor
  drop = 'd',     // the port was given up: stop the wheels on it, then let go of it
  let_go = 'l',   // of the port
  farewell = 'f'  // the daemon ends in order
};

// Never returns. `socket` is the guardian's end; every other descriptor but standard error is closed.
[[noreturn]] void guard(const GuardianConfig& config, int socket, GuardianBoard& board);

}  // namespace wheelwright::daemon
