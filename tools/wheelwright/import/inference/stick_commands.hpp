// Commands that are the axes of a joystick.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Fills in the command that `mapping` lacks, from columns that are named as those of a stick: one up and down
// for each wheel, or one that drives and one that turns. Where the names do not say which is which
// ("axes[1]") the wheels do. Of many sticks -1 is forward: that is seen in the wheels, and doubted without
// any.
void find_stick_commands(std::span<const Recording> recordings, Mapping& mapping,
                         std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
