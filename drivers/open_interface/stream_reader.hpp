// Frames of the sensor stream, found among whatever arrives.
//
// A frame is 19, n, then id and data of each packet, then a checksum (Roomba 500 Open Interface, page 18).
// iRobot's two documents disagree whether the 19 is summed: both rules are tried, and the one that keeps
// passing wins. Every byte is examined as a possible header again after a mismatch, so that a false header
// costs nothing.
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

// Which bytes make the sum that must end in zero.
enum class ChecksumRule : std::uint8_t {
  unknown,
  header_included,  // what robots do; Create 2 document
  header_excluded,  // Roomba 500 and Create documents
};

struct StreamCounts {
  std::uint64_t frames = 0;   // sound
  std::uint64_t corrupt = 0;  // began like a frame of ours, but failed the checksum or a range
  std::uint64_t stray_bytes = 0;
};

class StreamReader {
 public:
  StreamReader();

  // The packets to stream.
  std::span<const PacketId> packets() const { return std::span(list_).first(list_size_); }

  // Takes a byte; the reading where it completes a sound frame.
  std::optional<Reading> take(std::uint8_t byte);

  // How many frames came damaged between the last sound one and the one before it, by the bytes between them.
  // 0 for the first, and where so much came that it was no frames.
  int damaged_before() const { return damaged_before_; }

  ChecksumRule rule() const { return rule_; }
  const StreamCounts& counts() const { return counts_; }
  StrayText& stray_text() { return stray_text_; }

 private:
  static constexpr std::size_t max_packets = 32;
  static constexpr std::size_t max_bytes = 128;
  static constexpr std::uint32_t frames_that_settle_the_rule = 20;

  bool may_be_frame() const;
  bool checksum_passes();
  std::optional<Reading> decode() const;
  void drop_first_byte();
  void note_damage();

  std::array<PacketId, max_packets> list_{};
  std::size_t list_size_ = 0;
  std::size_t frame_bytes_ = 0;
  std::array<std::uint8_t, max_bytes> buffer_{};
  std::size_t size_ = 0;
  ChecksumRule rule_ = ChecksumRule::unknown;
  std::array<std::uint32_t, 2> passes_{};  // header included, header excluded
  std::size_t stray_since_frame_ = 0;
  int damaged_before_ = 0;
  StreamCounts counts_;
  StrayText stray_text_;
};

}  // namespace wheelwright::open_interface
