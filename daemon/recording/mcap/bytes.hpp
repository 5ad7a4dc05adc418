// Bytes as the MCAP format lays them out: little-endian numbers, texts with their length before them.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace wheelwright::mcap {

template <std::unsigned_integral Number>
void put(std::string& to, Number value) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    to.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xffU));
  }
}

inline void put_text(std::string& to, std::string_view text) {
  put(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}

// A record: what kind it is, how long it is, and its content.
inline void put_record(std::string& to, std::uint8_t kind, std::string_view content) {
  put(to, kind);
  put(to, static_cast<std::uint64_t>(content.size()));
  to += content;
}

}  // namespace wheelwright::mcap
