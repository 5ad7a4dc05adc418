// Times as programs print them, made ones that a table reader understands.
#pragma once

#include <string>

namespace wheelwright::import {

// "13:39:05,050 " as Python's logging writes it: the comma of the milliseconds becomes a point, if it stands
// in most of the lines. Line numbers and lengths stay.
void point_milliseconds(std::string& text);

}  // namespace wheelwright::import
