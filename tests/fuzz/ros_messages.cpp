// Message definitions and messages: parts of the input that form feeds divide. The first is the encoding
// (ros1, ros2, json), the second the definition, each other a message.
#include <string_view>
#include <vector>

#include "tests/fuzz/bag_invariants.hpp"
#include "tests/support/bag_bytes.hpp"

using namespace wheelwright;
namespace mcap = test::mcap_bytes;

namespace {

std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == '\f') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> parts = parts_of(fuzz::as_text(data, size));
  parts.resize(std::max<std::size_t>(parts.size(), 3));
  std::string file = std::string(mcap::magic) + mcap::header("");
  file += mcap::schema(1, "a/T", parts[0] == "ros1" ? "ros1msg" : "ros2msg", parts[1]);
  file += mcap::channel(1, 1, "/t", parts[0] == "ros2" ? "cdr" : parts[0]);
  for (std::size_t i = 2; i < parts.size(); ++i) file += mcap::message(1, i, parts[i]);
  fuzz::check_recording(import::read_ros_bytes(file + mcap::end(), "fuzz"));
  return 0;
}
