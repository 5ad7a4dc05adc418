// The `wheelwright` command as a function, for main and for tests.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {

// Runs one command line, without the name of the program. Never throws for what a person can get wrong: that
// is one line on streams.err and an exit status.
ExitStatus run_command_line(std::vector<std::string> arguments, Streams streams);

}  // namespace wheelwright::tools
