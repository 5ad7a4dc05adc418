// When the wheels of a simulated robot came to rest, by what it truly did.
#pragma once

#include "tests/loopback/bench/table.hpp"

namespace wheelwright::bench {

// The clock of the truth file, in milliseconds since 1970.
double unix_ms_now();

// Milliseconds from a moment until both wheels are slower than 1 mm/s, if they do not move again until
// `until_unix_ms`.
double ms_to_rest(const Table& truth, double from_unix_ms, double until_unix_ms = 1e30);

// Mean speed of the wheels at a moment, in m/s.
double speed_at(const Table& truth, double at_unix_ms);

}  // namespace wheelwright::bench
