#include "drivers/open_interface/query_reader.hpp"

#include <algorithm>
#include <cstdlib>

namespace wheelwright::open_interface {
namespace {

using enum PacketId;

constexpr int max_voltage_change_mv = 300;  // between the first and the last packet of one reply

}  // namespace

QueryReader::QueryReader() {
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    auto& list = lists_.at(kind);
    list_size_ = 0;
    const auto add_marks = [&](bool voltage_first) {
      list.at(list_size_++) = voltage_first ? voltage : oi_mode;
      list.at(list_size_++) = voltage_first ? oi_mode : voltage;
    };
    add_marks((kind & 1U) == 0);
    for (const PacketId id : reading_packets()) list.at(list_size_++) = id;
    add_marks((kind & 2U) == 0);
  }
  for (std::size_t i = 0; i < list_size_; ++i) reply_bytes_ += packet_info(lists_[0].at(i)).bytes;
  if (reply_bytes_ > max_bytes) std::abort();
}

std::span<const PacketId> QueryReader::begin() {
  close_last_query();
  kind_ = (kind_ + 1) % kinds;
  received_ = 0;
  waiting_ = true;
  ++counts_.asked;
  return std::span(lists_.at(kind_)).first(list_size_);
}

void QueryReader::close_last_query() {
  if (!waiting_) return;
  counts_.stray_bytes += received_;
  const std::size_t unused = std::min(received_, reply_bytes_);
  for (std::size_t i = reply_bytes_ - unused; i < reply_bytes_; ++i) stray_text_.take(window_.at(i));
  if (received_ == 0) {
    ++counts_.missing;
  } else if (received_ < reply_bytes_) {
    ++counts_.incomplete;
  } else {
    ++counts_.garbled;
  }
}

std::optional<Reading> QueryReader::take(std::uint8_t byte) {
  if (!waiting_) {
    ++counts_.stray_bytes;
    stray_text_.take(byte);
    return std::nullopt;
  }
  // A byte that leaves the window unused belongs to no reply.
  if (received_ >= reply_bytes_) stray_text_.take(window_[0]);
  std::shift_left(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(reply_bytes_), 1);
  window_.at(reply_bytes_ - 1) = byte;
  ++received_;
  if (received_ < reply_bytes_) return std::nullopt;
  auto reading = decode_window();
  if (!reading) return std::nullopt;
  waiting_ = false;
  ++counts_.sound;
  counts_.stray_bytes += received_ - reply_bytes_;
  return reading;
}

std::optional<Reading> QueryReader::decode_window() const {
  const auto& list = lists_.at(kind_);
  Reading reading;
  int first_voltage = -1;
  int first_mode = -1;
  std::size_t at = 0;
  for (std::size_t i = 0; i < list_size_; ++i) {
    const PacketInfo& packet = packet_info(list.at(i));
    const std::int32_t value = decode_value(packet, std::span(window_).subspan(at, packet.bytes));
    at += packet.bytes;
    if (!put(reading, packet, value)) return std::nullopt;
    if (packet.id == voltage && first_voltage < 0) first_voltage = value;
    if (packet.id == oi_mode && first_mode < 0) first_mode = value;
  }
  const bool marks_agree =
      std::abs(reading.voltage_mv - first_voltage) <= max_voltage_change_mv && reading.oi_mode == first_mode;
  return marks_agree ? std::optional(reading) : std::nullopt;
}

}  // namespace wheelwright::open_interface
