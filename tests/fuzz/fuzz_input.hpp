// A fuzzer's bytes, taken apart into what a target needs.
//
// Each target defines LLVMFuzzerTestOneInput. Under clang it is linked with libFuzzer (tools/fuzz); without,
// with replay_main.cpp, which runs it over the inputs of its corpus as an ordinary test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>

namespace wheelwright::fuzz {

// Bytes until they run out; then zeros.
class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  bool empty() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }
  // Any double at all: NaN, infinities, negative zero and 1e308 among them.
  double real() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = (bits << 8U) | byte();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

inline std::string as_text(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

// What must hold whatever the input; ends the process where it does not.
inline void must_hold(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace wheelwright::fuzz
