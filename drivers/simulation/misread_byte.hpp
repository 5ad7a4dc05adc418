// What a UART makes of bytes that were sent at another speed than its own.
//
// The line rests at 1; a byte is a 0, its eight bits from the lowest up, and a 1. The receiver waits for a
// fall, looks at the middle of each of its own bits, and drops what does not end in a 1 (a framing error).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace wheelwright::simulation {

// The most bytes that a receiver at four times the speed can read out of one.
inline constexpr std::size_t max_misread = 8;

// Reads what comes of one byte that a pause follows. `ratio` is the sender's speed over the receiver's.
// Returns how many bytes were written to `out`.
std::size_t misread(std::uint8_t sent, double ratio, std::span<std::uint8_t, max_misread> out);

}  // namespace wheelwright::simulation
