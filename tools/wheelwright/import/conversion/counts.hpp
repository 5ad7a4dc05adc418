// Encoder counts as the wheel turned them: a counter that wraps is unwrapped, and a log that writes a value
// only where it changes is filled.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace wheelwright::import {

// The width in bits of a counter that jumps by 2^bits where it wraps, from the counts themselves; nothing
// where they do not jump so. A jump is taken for a wrap where without it the counts go on as beside it.
std::optional<int> wrapped_bits(std::span<const double> counts);

// Adds or takes 2^bits at each jump by more than half of it; returns how often.
std::size_t unwrap(std::span<double> counts, int bits);

// Whether a column stands only where it changed: values never repeat, and the blanks between them are
// irregular.
bool is_log_on_change(std::span<const double> values);

// Every blank gets the value above it.
void fill_down(std::span<double> values);

}  // namespace wheelwright::import
