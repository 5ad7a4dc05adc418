#include "daemon/recording/mcap/crc32.hpp"

#include <array>

namespace wheelwright::mcap {
namespace {

constexpr std::size_t stride = 8;  // bytes taken in one step
using Table = std::array<std::array<std::uint32_t, 256>, stride>;

// tables[k][b]: what the byte b does to the checksum when k further bytes follow it in the same step.
constexpr Table make_tables() {
  Table tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    tables[0][byte] = value;
  }
  for (std::size_t k = 1; k < stride; ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t last = tables[k - 1][byte];
      tables[k][byte] = (last >> 8U) ^ tables[0][last & 0xffU];
    }
  }
  return tables;
}

constexpr Table tables = make_tables();

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

}  // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  std::uint32_t crc = ~before;
  std::size_t i = 0;
  for (; i + stride <= bytes.size(); i += stride) {
    const std::uint32_t first = crc ^ (byte_at(bytes, i) | byte_at(bytes, i + 1) << 8U |
                                       byte_at(bytes, i + 2) << 16U | byte_at(bytes, i + 3) << 24U);
    crc = tables[7][first & 0xffU] ^ tables[6][first >> 8U & 0xffU] ^ tables[5][first >> 16U & 0xffU] ^
          tables[4][first >> 24U] ^ tables[3][byte_at(bytes, i + 4)] ^ tables[2][byte_at(bytes, i + 5)] ^
          tables[1][byte_at(bytes, i + 6)] ^ tables[0][byte_at(bytes, i + 7)];
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8U) ^ tables[0][(crc ^ byte_at(bytes, i)) & 0xffU];
  return ~crc;
}

}  // namespace wheelwright::mcap
