// Rows of several kinds in one table, which take turns: of topics, sensors, tags, robots.
#pragma once

#include <cstddef>
#include <optional>

#include "tools/wheelwright/import/formats/text/text_table.hpp"

namespace wheelwright::import {

// Makes texts of the whole numbers of tags, bodies or robots ("tag_id 7") where a column of the table jumps
// from one to the next and goes evenly by each.
void label_numbers(TextTable& table);

// The column of texts that says of which kind a row is; of several the one with the most texts.
std::optional<std::size_t> find_kind_column(const TextTable& table);

}  // namespace wheelwright::import
