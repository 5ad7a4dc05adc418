#include "tools/wheelwright/import/formats/matlab/mat_element.hpp"

#include <zlib.h>

#include <algorithm>

#include "tools/wheelwright/import/formats/little_endian.hpp"

namespace wheelwright::import {
namespace {

using Failure = tl::unexpected<std::string>;

constexpr std::size_t tag_bytes = 8;

template <typename Integer>
double signed_value(std::uint64_t bits) {
  return static_cast<double>(static_cast<Integer>(bits));
}

double number_of(std::uint64_t bits, MatType type) {
  switch (type) {
    case MatType::int8:
      return signed_value<std::int8_t>(bits);
    case MatType::int16:
      return signed_value<std::int16_t>(bits);
    case MatType::int32:
      return signed_value<std::int32_t>(bits);
    case MatType::int64:
      return signed_value<std::int64_t>(bits);
    case MatType::single_precision:
      return float_of(bits);
    case MatType::double_precision:
      return double_of(bits);
    default:
      return static_cast<double>(bits);
  }
}

// Ends the decompression whichever way it is left.
class Inflater {
 public:
  Inflater() : is_open_(inflateInit(&stream_) == Z_OK) {}
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (is_open_) inflateEnd(&stream_);
  }
  bool is_open() const { return is_open_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
  bool is_open_;
};

}  // namespace

std::uint64_t unsigned_number(std::string_view bytes, bool is_big_endian) {
  return is_big_endian ? big_endian(bytes) : little_endian(bytes);
}

tl::expected<MatElement, std::string> MatElements::next() {
  const std::uint64_t first = unsigned_number(rest_.substr(0, 4), is_big_endian_);
  if (first >> 16U != 0) {  // a small element: two bytes each for size and type
    const std::size_t size = first >> 16U;
    if (size > 4) {
      rest_ = {};
      return Failure("a small element says that it has " + std::to_string(size) + " bytes, but holds 4");
    }
    const MatElement element{static_cast<MatType>(first & 0xffffU), rest_.substr(4, size)};
    rest_.remove_prefix(tag_bytes);
    return element;
  }
  const std::uint64_t size = unsigned_number(rest_.substr(4, 4), is_big_endian_);
  const std::size_t left = rest_.size() - tag_bytes;
  if (size > left) {
    rest_ = {};
    return Failure("an element of " + std::to_string(size) + " bytes, of which " + std::to_string(left) +
                   " are there");
  }
  const MatElement element{static_cast<MatType>(first), rest_.substr(tag_bytes, size)};
  const bool is_padded = element.type != MatType::compressed;
  const std::size_t padding = is_padded ? (8 - size % 8) % 8 : 0;
  rest_.remove_prefix(tag_bytes + std::min<std::size_t>(size + padding, left));
  return element;
}

std::size_t number_bytes(MatType type) {
  switch (type) {
    case MatType::int8:
    case MatType::uint8:
    case MatType::utf8:
      return 1;
    case MatType::int16:
    case MatType::uint16:
    case MatType::utf16:
      return 2;
    case MatType::int32:
    case MatType::uint32:
    case MatType::single_precision:
    case MatType::utf32:
      return 4;
    case MatType::double_precision:
    case MatType::int64:
    case MatType::uint64:
      return 8;
    default:
      return 0;
  }
}

std::vector<double> numbers_of(const MatElement& element, bool is_big_endian) {
  const std::size_t size = number_bytes(element.type);
  if (size == 0) return {};
  std::vector<double> numbers(element.data.size() / size);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = number_of(unsigned_number(element.data.substr(i * size, size), is_big_endian), element.type);
  return numbers;
}

tl::expected<std::string, std::string> inflate_element(std::string_view compressed, std::size_t max_bytes) {
  constexpr std::size_t block_bytes = 256U << 10U;
  Inflater inflater;
  if (!inflater.is_open()) return Failure("no memory to decompress");
  z_stream& stream = inflater.stream();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
  stream.avail_in = static_cast<uInt>(compressed.size());  // of a tag with four bytes for it
  std::string bytes;
  std::size_t filled = 0;
  int status = Z_OK;
  while (status == Z_OK) {
    if (filled == bytes.size()) {
      if (filled >= max_bytes)
        return Failure("more than " + std::to_string(max_bytes >> 20U) + " MiB of data");
      bytes.resize(std::min(std::max(2 * filled, block_bytes), max_bytes));
    }
    const std::size_t room = std::min(bytes.size() - filled, std::size_t{1} << 30U);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + filled);
    stream.avail_out = static_cast<uInt>(room);
    status = inflate(&stream, Z_NO_FLUSH);
    filled += room - stream.avail_out;
    if (status == Z_BUF_ERROR && stream.avail_in > 0) status = Z_OK;
  }
  if (status != Z_STREAM_END) return Failure("its compressed data are damaged or cut short");
  bytes.resize(filled);
  return bytes;
}

}  // namespace wheelwright::import
