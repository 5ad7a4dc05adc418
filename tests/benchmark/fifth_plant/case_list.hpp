#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmark/fifth_plant/case_builder.hpp"

namespace plants::fifth {

// Each name in two sizes, several at once, none, such as the drives cannot tell, and such as have no name; in
// an order that does not tell.
std::vector<BuiltCase> build_cases(std::uint64_t seed);
std::vector<ExamCase> make_cases(std::uint64_t seed);

}  // namespace plants::fifth
