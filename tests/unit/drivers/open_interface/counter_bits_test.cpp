#include "drivers/open_interface/counter_bits.hpp"

#include "tests/support/catch.hpp"

using wheelwright::open_interface::CounterBits;

namespace {

// The bits that are found stuck after a wheel has gone `ticks` far by `step` ticks a sample, behind a line
// that keeps the bits of `mask` and sets those of `set`.
unsigned stuck_after(int ticks, int step, unsigned mask, unsigned set = 0) {
  CounterBits bits;
  unsigned before = mask | set;
  for (int at = 0; at <= ticks; at += step) {
    const unsigned low = ((static_cast<unsigned>(at) & mask) | set) & 0xFFU;
    const unsigned raw = (static_cast<unsigned>(at) & 0xFF00U) | low;
    bits.take(static_cast<std::uint16_t>(raw),
              at == 0 ? 0 : static_cast<int>(raw) - static_cast<int>(before));
    before = raw;
  }
  return bits.stuck();
}

}  // namespace

TEST_CASE("Counts of a sound line are never found stuck, however fast the wheel turns") {
  for (const int step : {1, 2, 5, 11, 20, 31}) {
    CAPTURE(step);
    CHECK(stuck_after(20000, step, 0xFF) == 0);
  }
}

TEST_CASE("A bit that the line loses or sets is found once the wheel has gone twice through the low byte") {
  for (const unsigned bit : {0x40U, 0x20U}) {
    for (const int step : {1, 5, 20}) {
      CAPTURE(bit, step);
      CHECK(stuck_after(200, step, 0xFF & ~bit) == 0);
      CHECK(stuck_after(2000, step, 0xFF & ~bit) == bit);
      CHECK(stuck_after(2000, step, 0xFF, bit) == bit);
    }
  }
}
