// Logs of FRC robots (WPILOG), record by record.
#include "tools/wheelwright/import/formats/wpilog/wpilog.hpp"

#include <cstdint>
#include <cstring>
#include <string>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

std::string little_endian_32(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xffU);
  return bytes;
}

// With a number of one byte for the entry, and four bytes each for the size and the timestamp.
std::string record(std::uint8_t entry, std::uint32_t t_us, const std::string& payload) {
  return std::string(1, '\x3c') + static_cast<char>(entry) +
         little_endian_32(static_cast<std::uint32_t>(payload.size())) + little_endian_32(t_us) + payload;
}

std::string start(std::uint8_t entry, const std::string& name, const std::string& type) {
  const auto text = [](const std::string& value) {
    return little_endian_32(static_cast<std::uint32_t>(value.size())) + value;
  };
  return record(0, 0, std::string(1, '\0') + little_endian_32(entry) + text(name) + text(type) + text(""));
}

std::string doubles(std::size_t count, double value) {
  std::string bytes(count * sizeof value, '\0');
  for (std::size_t i = 0; i < count; ++i) std::memcpy(bytes.data() + i * sizeof value, &value, sizeof value);
  return bytes;
}

}  // namespace

TEST_CASE("An array for which there is no memory costs itself, and no record that comes later") {
  constexpr std::uint32_t rows = 6000;
  std::string log = std::string("WPILOG\x00\x01", 8) + little_endian_32(0) + start(1, "lidar", "double[]") +
                    start(2, "enc", "double");
  for (std::uint32_t row = 0; row < rows; ++row) log += record(1, row, doubles(1, 0.5));
  log += record(1, rows, doubles(4096, 0.5));
  for (std::uint32_t row = 0; row < 100; ++row) log += record(2, rows + row, doubles(1, row));
  const auto recording = import::read_wpilog(log, "robot.wpilog");
  if (!recording) FAIL(recording.error());
  const import::Stream* enc = recording->find("enc");
  REQUIRE(enc != nullptr);
  CHECK(enc->rows == 100);
  CHECK(enc->find("value")->values.back() == 99.0);
  CHECK(recording->find("lidar")->rows == rows);
  REQUIRE(recording->remarks.size() == 1);
  CHECK_THAT(recording->remarks.front(), ContainsSubstring("'lidar': 1 arrays of another length"));
}
