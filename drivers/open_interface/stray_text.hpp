// Readable text on the serial line: a docked, booting or sleeping robot prints some by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace wheelwright::open_interface {

// Collects runs of printable characters out of bytes that belong to nothing else. No allocation.
class StrayText {
 public:
  // Takes a byte that belonged to no reply.
  void take(std::uint8_t byte) {
    const bool printable = byte >= 0x20 && byte < 0x7F;
    if (printable && size_ < text_.size()) {
      text_[size_++] = static_cast<char>(byte);
    } else {
      if (size_ >= shortest) finished_ = size_;
      if (finished_ == 0) size_ = 0;
    }
  }

  // The last finished run, or empty; taking it makes room for the next.
  std::string_view finished() const { return {text_.data(), finished_}; }
  void discard() {
    finished_ = 0;
    size_ = 0;
  }

 private:
  static constexpr std::size_t shortest = 6;  // fewer are found in any data
  std::array<char, 80> text_{};
  std::size_t size_ = 0;
  std::size_t finished_ = 0;
};

}  // namespace wheelwright::open_interface
