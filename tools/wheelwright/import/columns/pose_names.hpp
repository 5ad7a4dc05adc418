// What a name says of a pose: a place, a heading, a part of a rotation, or where the robot is to go.
#pragma once

#include <optional>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"

namespace wheelwright::import {

// Of a channel without a side. Nothing where the name is of no pose.
std::optional<Quantity> pose_quantity(const NameWords& words, bool is_command, const Stream& stream);

// Whether a name with x or y is that of a path or of a controller's reference ("x_ref", "path_x", "x_d"),
// which may be what is wanted or what was measured.
bool may_be_wanted(const NameWords& words);

// Whether places of that name are to the north or the east by definition.
bool is_northward(const NameWords& words);
bool is_eastward(const NameWords& words);

}  // namespace wheelwright::import
