#pragma once

#include "tests/benchmark/second_plant/programme.hpp"

namespace plants::second {

// Draws one manoeuvre of the rich repertoire.
Programme rich_manoeuvre(const ProgrammeLimits& limits, Random& random);

// Draws one manoeuvre with no command between zero and `smallest_m_s`.
Programme bold_manoeuvre(const ProgrammeLimits& limits, double smallest_m_s, Random& random);

// Appends a hold of constant commands.
void append_hold(Programme& programme, const ProgrammeLimits& limits, PerWheel<double> command_m_s,
                 double duration_s);

// Appends a linear change from one command to another.
void append_ramp(Programme& programme, const ProgrammeLimits& limits, PerWheel<double> from_m_s,
                 PerWheel<double> to_m_s, double duration_s);

}  // namespace plants::second
