// Which cases the gap benchmark consists of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/gap_plant/gap_case.hpp"

namespace wheelwright::test {

// `quick`: each effect once in medium size, and some of the rest. Else each in three sizes and with less to
// see, pairs and triples, clean logs, logs that cannot tell, and effects that no library holds. Each case has
// a seed of its own, which depends on `seed` and on its place in the list.
std::vector<GapCaseSpec> gap_suite(bool quick, std::uint64_t seed);

}  // namespace wheelwright::test
