// The commands of a robot by the names of its columns: of two wheels, of the body, of a remote control.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// Nothing where no name is that of a command; lines in `findings` where others were there, or where it is
// held for most rows and called a speed. `has_wheels`: wheels were found beside it.
std::optional<CommandMapping> find_named_command(const NamedChannels& named, bool has_wheels,
                                                 std::vector<std::string>& findings);

}  // namespace wheelwright::import
