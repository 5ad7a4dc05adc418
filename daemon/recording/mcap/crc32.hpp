// The checksum of the MCAP format: CRC-32 of IEEE 802.3 (reflected polynomial 0xEDB88320), as in zip and PNG.
#pragma once

#include <cstdint>
#include <string_view>

namespace wheelwright::mcap {

// Goes on from the checksum of what came before; that of nothing is 0.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace wheelwright::mcap
