// MCAP files: the bytes behind the magic.
#include "tests/fuzz/bag_invariants.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::check_recording(import::read_ros_bytes("\x89MCAP0\r\n" + fuzz::as_text(data, size), "fuzz"));
  return 0;
}
