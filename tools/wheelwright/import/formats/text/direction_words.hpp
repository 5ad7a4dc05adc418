// Columns that say in words which way a motor turns: "fwd" and "rev", "F" and "B", "forward", "backward",
// "stop".
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/import/formats/text/text_table.hpp"

namespace wheelwright::import {

// Makes them numbers: 1 forward, -1 backward, 0 for standing. Only where every text of a column is such a
// word, and both ways occur.
void read_direction_words(TextTable& table, std::vector<std::string>& remarks);

}  // namespace wheelwright::import
