#include "tools/wheelwright/import/conversion/counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wheelwright::import {
namespace {

constexpr std::array counter_widths{8, 16, 24, 32};
constexpr std::array shaft_encoder_widths{10, 12, 14};  // of a turn
constexpr std::size_t min_changes = 5;

// Largest step of counts that are unwrapped at `modulus`, and how many jumps there are.
struct Steps {
  double largest = 0.0;
  std::size_t wraps = 0;
};

Steps steps_at(std::span<const double> counts, double modulus) {
  Steps steps;
  const double* last = nullptr;
  for (const double& count : counts) {
    if (!std::isfinite(count)) continue;
    if (last != nullptr) {
      const double step = count - *last;
      const double turns = std::round(step / modulus);
      if (turns != 0.0) ++steps.wraps;
      steps.largest = std::max(steps.largest, std::abs(step - turns * modulus));
    }
    last = &count;
  }
  return steps;
}

}  // namespace

std::optional<int> wrapped_bits(std::span<const double> counts) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  for (const double count : counts) {
    if (!std::isfinite(count)) continue;
    if (count != std::round(count)) return std::nullopt;
    lowest = std::min(lowest, count);
    highest = std::max(highest, count);
  }
  if (!(highest > lowest)) return std::nullopt;
  for (const int bits : counter_widths) {
    const double modulus = std::ldexp(1.0, bits);
    const bool is_unsigned = lowest >= 0.0 && highest < modulus;
    const bool is_signed = lowest >= -modulus / 2 && highest < modulus / 2;
    // A counter that wraps comes near both ends.
    if (!(is_unsigned || is_signed) || highest - lowest < 0.6 * modulus) continue;
    const Steps steps = steps_at(counts, modulus);
    if (steps.wraps > 0 && steps.largest < 0.4 * modulus) return bits;
  }
  // Fewer bits are told from a counter that was set to zero by both ends, and by several wraps.
  for (const int bits : shaft_encoder_widths) {
    const double modulus = std::ldexp(1.0, bits);
    if (lowest < 0.0 || lowest > 0.05 * modulus || highest >= modulus || highest < 0.95 * modulus) continue;
    const Steps steps = steps_at(counts, modulus);
    if (steps.wraps > 2 && steps.largest < 0.25 * modulus) return bits;
  }
  return std::nullopt;
}

std::size_t unwrap(std::span<double> counts, int bits) {
  const double modulus = std::ldexp(1.0, bits);
  double offset = 0.0;
  double last = std::numeric_limits<double>::quiet_NaN();
  std::size_t wraps = 0;
  for (double& count : counts) {
    if (!std::isfinite(count)) continue;
    if (std::isfinite(last)) {
      const double turns = std::round((count - last) / modulus);
      offset -= turns * modulus;
      if (turns != 0.0) ++wraps;
    }
    last = count;
    count += offset;
  }
  return wraps;
}

bool is_log_on_change(std::span<const double> values) {
  std::size_t changes_behind_blanks = 0;
  std::size_t shortest = values.size();
  std::size_t longest = 0;
  std::size_t blanks = 0;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) {
      ++blanks;
      continue;
    }
    if (std::isfinite(last)) {
      if (value == last) return false;
      shortest = std::min(shortest, blanks);
      longest = std::max(longest, blanks);
      if (blanks > 0) ++changes_behind_blanks;
    }
    last = value;
    blanks = 0;
  }
  return changes_behind_blanks >= min_changes && longest > shortest + 1;
}

void fill_down(std::span<double> values) {
  double last = std::numeric_limits<double>::quiet_NaN();
  for (double& value : values) {
    if (std::isfinite(value)) {
      last = value;
    } else {
      value = last;
    }
  }
}

}  // namespace wheelwright::import
