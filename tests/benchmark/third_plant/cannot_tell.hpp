#pragma once

#include <vector>

#include "tests/benchmark/third_plant/case_builder.hpp"

namespace plants::third {

// Cases in which an effect is there but the logs cannot show it.
void add_cannot_tell(std::vector<Case>& cases, CaseBuilder& builder, const std::vector<Effect>& effects);

}  // namespace plants::third
