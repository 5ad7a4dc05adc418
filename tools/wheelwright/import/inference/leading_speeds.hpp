// Forward and turning speeds that nothing names as commands, and that the wheels follow.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Takes "v" and "w" beside wheels for the commands where none was found, or a duty that a controller made of
// them: if they explain 70 % of way and turn (90 % beside a duty; 30 % if they are held for most rows), and
// the wheels come behind them, as behind no measured speed; a line in `findings`.
void find_leading_speeds(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings);

}  // namespace wheelwright::import
