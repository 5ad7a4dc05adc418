// Counts of an encoder that jump, roll over and change their sign as they like.
#include "drivers/open_interface/encoder_counter.hpp"

#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  open_interface::EncoderCounter counter;
  constexpr int max_change = 300;
  while (!input.empty()) {
    const std::uint8_t event = input.byte();
    if (event == 0) counter.rebase();
    if (event == 1) counter.forget_signs();
    const auto raw = static_cast<std::uint16_t>((input.byte() << 8U) | input.byte());
    const auto before = counter.counted();
    const bool taken = counter.update(raw, event % 3 - 1.0, max_change);
    const auto change = counter.counted() - before;
    fuzz::must_hold(taken || change == 0, "what is not taken changes nothing");
    fuzz::must_hold(change >= -max_change && change <= max_change, "no change beyond what a wheel can do");
  }
  return 0;
}
