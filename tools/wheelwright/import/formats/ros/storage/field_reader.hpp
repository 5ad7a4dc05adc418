// Takes little-endian values off the front of bytes. What does not fit reads as zero or as empty, and ok() is
// false from then on, so that a record is read to its end and judged once.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace wheelwright::import::ros {

static_assert(std::endian::native == std::endian::little, "bags are little-endian");

class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : rest_(bytes) {}

  template <typename Number>
  Number number() {
    Number value{};
    const std::string_view part = bytes(sizeof value);
    if (part.size() == sizeof value) std::memcpy(&value, part.data(), sizeof value);
    return value;
  }
  std::string_view bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const std::string_view part = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return part;
  }
  // A length of 32 bits, and as many bytes.
  std::string_view text() { return bytes(number<std::uint32_t>()); }

  std::string_view rest() const { return rest_; }
  bool ok() const { return ok_; }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace wheelwright::import::ros
