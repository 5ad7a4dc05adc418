#include "drivers/open_interface/stream_reader.hpp"

#include <algorithm>
#include <numeric>

namespace wheelwright::open_interface {
namespace {

constexpr std::uint8_t header = 19;

}  // namespace

StreamReader::StreamReader() {
  list_.at(list_size_++) = PacketId::voltage;
  list_.at(list_size_++) = PacketId::oi_mode;
  for (const PacketId id : reading_packets()) list_.at(list_size_++) = id;
  frame_bytes_ = 3;
  for (const PacketId id : packets()) frame_bytes_ += 1U + packet_info(id).bytes;
}

std::optional<Reading> StreamReader::take(std::uint8_t byte) {
  buffer_.at(size_++) = byte;
  while (size_ > 0 && !may_be_frame()) drop_first_byte();
  if (size_ < frame_bytes_) return std::nullopt;
  const auto reading = checksum_passes() ? decode() : std::nullopt;
  if (reading) {
    note_damage();
    ++counts_.frames;
    size_ = 0;
    return reading;
  }
  ++counts_.corrupt;
  do drop_first_byte();
  while (size_ > 0 && !may_be_frame());
  return std::nullopt;
}

// Whether the bytes so far agree with a frame: header, length, and each packet id at its place.
bool StreamReader::may_be_frame() const {
  if (buffer_[0] != header) return false;
  if (size_ > 1 && buffer_[1] != frame_bytes_ - 3) return false;
  std::size_t at = 2;
  for (const PacketId id : packets()) {
    if (at >= size_) return true;
    if (buffer_.at(at) != static_cast<std::uint8_t>(id)) return false;
    at += 1U + packet_info(id).bytes;
  }
  return true;
}

bool StreamReader::checksum_passes() {
  const auto sum =
      std::accumulate(buffer_.begin() + 1, buffer_.begin() + static_cast<std::ptrdiff_t>(frame_bytes_), 0U);
  const bool included = ((sum + header) & 0xFFU) == 0;
  const bool excluded = (sum & 0xFFU) == 0;
  if (rule_ == ChecksumRule::header_included) return included;
  if (rule_ == ChecksumRule::header_excluded) return excluded;
  passes_[0] += included ? 1 : 0;
  passes_[1] += excluded ? 1 : 0;
  if (passes_[0] >= frames_that_settle_the_rule) rule_ = ChecksumRule::header_included;
  if (passes_[1] >= frames_that_settle_the_rule) rule_ = ChecksumRule::header_excluded;
  return included || excluded;
}

std::optional<Reading> StreamReader::decode() const {
  Reading reading;
  std::size_t at = 2;
  for (const PacketId id : packets()) {
    const PacketInfo& packet = packet_info(id);
    const std::int32_t value = decode_value(packet, std::span(buffer_).subspan(at + 1, packet.bytes));
    if (!put(reading, packet, value)) return std::nullopt;
    at += 1U + packet.bytes;
  }
  return reading;
}

void StreamReader::note_damage() {
  constexpr int most = 10;
  const auto damaged = static_cast<int>((stray_since_frame_ + frame_bytes_ / 2) / frame_bytes_);
  damaged_before_ = counts_.frames > 0 && damaged <= most ? damaged : 0;
  stray_since_frame_ = 0;
}

void StreamReader::drop_first_byte() {
  ++counts_.stray_bytes;
  ++stray_since_frame_;
  stray_text_.take(buffer_[0]);
  std::shift_left(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size_), 1);
  --size_;
}

}  // namespace wheelwright::open_interface
