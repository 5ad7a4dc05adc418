// The two files of a robot of the MRCLAM data set, parted by a form feed.
#include "config/load/mrclam_files.hpp"
#include "config/load/drive_log_file.hpp"
#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::as_text(data, size);
  const auto parted = std::min(text.find('\f'), text.size());
  try {
    config::parse_mrclam_run({"odometry.dat", text.substr(0, parted)},
                             {"groundtruth.dat", parted < text.size() ? text.substr(parted + 1) : ""});
  } catch (const config::LogError&) {
  }
  return 0;
}
