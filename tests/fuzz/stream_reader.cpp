// Bytes from a robot in stream mode.
#include "drivers/open_interface/stream_reader.hpp"

#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  open_interface::StreamReader reader;
  std::uint64_t readings = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto reading = reader.take(data[i]);
    if (!reading) continue;
    ++readings;
    fuzz::must_hold(reading->voltage_mv >= open_interface::lowest_voltage_mv &&
                        reading->voltage_mv <= open_interface::highest_voltage_mv,
                    "a reading's voltage is one that a battery can have");
  }
  fuzz::must_hold(reader.counts().frames == readings, "each reading is counted");
  fuzz::must_hold(reader.counts().stray_bytes <= size, "no more stray bytes than bytes");
  return 0;
}
