#pragma once

#include <vector>

#include "tests/benchmark/second_plant/case_builder.hpp"

namespace plants::second {

// Cases in which an effect is there but the logs cannot show it, or cannot tell it from another.
void add_cannot_tell(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects);

}  // namespace plants::second
