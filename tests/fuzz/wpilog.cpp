// A WPILOG file.
#include "tools/wheelwright/import/formats/wpilog/wpilog.hpp"

#include "tests/fuzz/fuzz_input.hpp"
#include "tests/fuzz/whole_recording.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::as_text(data, size);
  import::is_wpilog(bytes);
  fuzz::check_recording(import::read_wpilog(bytes, "fuzz.wpilog"));
  return 0;
}
