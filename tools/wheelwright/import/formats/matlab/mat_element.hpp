// A data element of a MATLAB file of level 5: a tag of type and size, then its bytes, padded to eight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import {

enum class MatType : std::uint32_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  single_precision = 7,
  double_precision = 9,
  int64 = 12,
  uint64 = 13,
  matrix = 14,
  compressed = 15,
  utf8 = 16,
  utf16 = 17,
  utf32 = 18,
};

struct MatElement {
  MatType type{};
  std::string_view data;
};

// Takes elements off the front of some bytes.
class MatElements {
 public:
  MatElements(std::string_view bytes, bool is_big_endian) : rest_(bytes), is_big_endian_(is_big_endian) {}

  bool is_at_end() const { return rest_.size() < 8; }
  bool is_big_endian() const { return is_big_endian_; }
  std::string_view rest() const { return rest_; }
  // Small elements have their data within the tag. Fails where an element is longer than what is left; then
  // nothing is left.
  tl::expected<MatElement, std::string> next();

 private:
  std::string_view rest_;
  bool is_big_endian_;
};

// The numbers of an element, whichever type they were stored in: level 5 stores a double array of small whole
// numbers as bytes. Empty where the type holds none.
std::vector<double> numbers_of(const MatElement& element, bool is_big_endian);
// Bytes of one number; 0 where the type holds none.
std::size_t number_bytes(MatType type);
std::uint64_t unsigned_number(std::string_view bytes, bool is_big_endian);

// The bytes of a compressed element; fails where they are damaged or more than `max_bytes`.
tl::expected<std::string, std::string> inflate_element(std::string_view compressed, std::size_t max_bytes);

}  // namespace wheelwright::import
