// What the hybrid filter found, in words: for the person who watches, and as fields of the pose log.
#pragma once

#include <string>

#include "model/filter/fault.hpp"

namespace wheelwright::daemon {

// One line: "left wheel: frozen encoder, 31.2 mm off".
std::string sentence_of(const FaultEvent& event);

// All events of a tick in one field without comma: "began spike left 0.0312; ended spike left 0.0312". Sizes
// in metres of wheel travel, for a stalled wheel and a slipping robot in amperes. Empty where nothing
// happened.
std::string field_of(const FaultEvents& events);

}  // namespace wheelwright::daemon
