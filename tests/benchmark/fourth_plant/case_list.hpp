#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmark/plants/exam.hpp"

namespace plants::fourth {

// In an order that does not tell.
std::vector<ExamCase> make_cases(std::uint64_t seed);

}  // namespace plants::fourth
