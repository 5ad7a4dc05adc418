#include "daemon/recording/mcap/crc32.hpp"

#include <zlib.h>

namespace wheelwright::mcap {

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace wheelwright::mcap
