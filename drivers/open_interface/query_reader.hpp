// Replies to the query list, found among whatever arrives.
//
// A reply is bare data: no frame, no checksum (Roomba 500 Open Interface, page 19). So the list is built to
// carry its own marks. It begins and ends with the OI mode and the battery voltage, both of a narrow range,
// and both copies must agree; and their order in front and behind goes through its four kinds from tick to
// tick, so that a reply that comes up to three ticks late is not taken for the new one. All bytes since the
// query are searched for a segment that fits: text in front, a late tail or lost bytes cost the sample that
// they hit and shift nothing after it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/open_interface/packets.hpp"
#include "drivers/open_interface/reading.hpp"
#include "drivers/open_interface/stray_text.hpp"

namespace wheelwright::open_interface {

// How the replies came, since the start.
struct ReplyCounts {
  std::uint64_t asked = 0;
  std::uint64_t sound = 0;
  std::uint64_t missing = 0;      // not one byte
  std::uint64_t incomplete = 0;   // fewer bytes than a reply has
  std::uint64_t garbled = 0;      // enough bytes, but no segment that fits
  std::uint64_t stray_bytes = 0;  // bytes that belonged to no sound reply
};

class QueryReader {
 public:
  QueryReader();

  // Begins a new query: what is still on its way from the last one no longer counts. Returns the packets to
  // ask for.
  std::span<const PacketId> begin();

  // Takes a byte; the reading where it completes a sound reply to the current query.
  std::optional<Reading> take(std::uint8_t byte);

  const ReplyCounts& counts() const { return counts_; }
  StrayText& stray_text() { return stray_text_; }
  std::size_t reply_bytes() const { return reply_bytes_; }

 private:
  static constexpr std::size_t max_packets = 32;
  static constexpr std::size_t max_bytes = 64;
  static constexpr std::size_t kinds = 4;

  std::optional<Reading> decode_window() const;
  void close_last_query();

  std::array<std::array<PacketId, max_packets>, kinds> lists_{};
  std::size_t list_size_ = 0;
  std::size_t reply_bytes_ = 0;
  std::size_t kind_ = 0;  // of the current query's list
  bool waiting_ = false;
  std::array<std::uint8_t, max_bytes> window_{};  // the last bytes, oldest first
  std::size_t received_ = 0;                      // bytes since the query
  ReplyCounts counts_;
  StrayText stray_text_;
};

}  // namespace wheelwright::open_interface
