// A text of any kind, read as a recording: what comes out is whole, whatever came in.
#include "tools/wheelwright/import/formats/text/text_recording.hpp"

#include "tests/fuzz/fuzz_input.hpp"
#include "tests/fuzz/whole_recording.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::as_text(data, size);
  import::is_text(text);
  fuzz::check_recording(import::read_text_table(text, "fuzz.csv"));
  return 0;
}
