// One of the two drive wheels.
#pragma once

#include <cstdint>

namespace wheelwright {

enum class WheelSide : std::uint8_t { left, right };

}  // namespace wheelwright
