// A place in a serialised message. What is beyond its end reads as zero, and has_failed() is true from then
// on.
//
// ROS 1 (wiki.ros.org/ROS/Technical Overview): little-endian, without alignment, strings with a length of 32
// bits. ROS 2: CDR (OMG DDS-RTPS 10.2, DDS-XTypes 7.4), either byte order, values aligned to their size, or
// to at most 4 bytes in its second version, strings ended by a zero byte that their length counts.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace wheelwright::import::ros {

struct WireFormat {
  std::size_t max_alignment = 1;  // a power of two
  bool is_swapped = false;        // against this machine
  bool has_zero_ended_strings = false;
};

class WireCursor {
 public:
  WireCursor(std::string_view bytes, const WireFormat& format) : bytes_(bytes), format_(format) {}

  template <typename Number>
  Number number() {
    align(sizeof(Number));
    Number value{};
    if (left() < sizeof value) {
      fail();
      return value;
    }
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return format_.is_swapped ? swapped(value) : value;
  }

  std::uint32_t count() { return number<std::uint32_t>(); }

  // `count` values of `size` bytes each, at once.
  void skip(std::uint64_t count, std::uint64_t size, std::size_t alignment) {
    if (count == 0 || size == 0) return;
    align(alignment);
    if (count > left() / size) return fail();
    at_ += count * size;
  }

  std::string_view text() {
    const std::uint32_t length = count();
    if (length > left()) {
      fail();
      return {};
    }
    std::string_view text = bytes_.substr(at_, length);
    at_ += length;
    if (format_.has_zero_ended_strings && text.ends_with('\0')) text.remove_suffix(1);
    return text;
  }

  std::size_t left() const { return bytes_.size() - at_; }
  std::size_t place() const { return at_; }
  bool has_failed() const { return has_failed_; }
  void fail() {
    has_failed_ = true;
    at_ = bytes_.size();
  }

 private:
  void align(std::size_t size) {
    const std::size_t alignment = std::min(size, format_.max_alignment);
    const std::size_t aligned = (at_ + alignment - 1) & ~(alignment - 1);
    if (aligned > bytes_.size()) return fail();
    at_ = aligned;
  }
  template <typename Number>
  static Number swapped(Number value) {
    unsigned char raw[sizeof(Number)];
    std::memcpy(raw, &value, sizeof value);
    std::reverse(raw, raw + sizeof value);
    std::memcpy(&value, raw, sizeof value);
    return value;
  }

  std::string_view bytes_;
  WireFormat format_;
  std::size_t at_ = 0;
  bool has_failed_ = false;
};

}  // namespace wheelwright::import::ros
