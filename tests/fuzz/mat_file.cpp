// A MATLAB file.
#include "tools/wheelwright/import/formats/matlab/mat_file.hpp"

#include "tests/fuzz/fuzz_input.hpp"
#include "tests/fuzz/whole_recording.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::as_text(data, size);
  import::is_mat_file(bytes);
  fuzz::check_recording(import::read_mat_file(bytes, "fuzz.mat"));
  return 0;
}
