#include <array>
#include <optional>

#include "tools/wheelwright/import/formats/matlab/mat_element.hpp"
#include "tools/wheelwright/import/formats/matlab/mat_variable.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t head_bytes = 20;
constexpr std::size_t longest_name = 128;  // with the zero at its end

struct MatrixHead {
  bool is_big_endian = false;
  MatType type{};
  bool is_full = false;  // no text and not sparse
  bool is_complex = false;
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  std::uint64_t name_bytes = 0;
};

// Five integers; the first has byte order, type of the numbers and kind of the matrix as decimal digits.
std::optional<MatrixHead> read_head(std::string_view bytes, bool is_big_endian) {
  constexpr std::array<MatType, 6> types{MatType::double_precision,
                                         MatType::single_precision,
                                         MatType::int32,
                                         MatType::int16,
                                         MatType::uint16,
                                         MatType::uint8};
  if (bytes.size() < head_bytes) return std::nullopt;
  const auto field = [&](std::size_t at) { return unsigned_number(bytes.substr(4 * at, 4), is_big_endian); };
  const std::uint64_t kind = field(0);
  const std::uint64_t order = is_big_endian ? 1 : 0;
  if (kind / 1000 != order || kind / 100 % 10 != 0 || kind / 10 % 10 >= types.size() || kind % 10 > 2)
    return std::nullopt;
  MatrixHead head;
  head.is_big_endian = is_big_endian;
  head.type = types.at(kind / 10 % 10);
  head.is_full = kind % 10 == 0;
  head.rows = field(1);
  head.columns = field(2);
  head.is_complex = field(3) == 1;
  head.name_bytes = field(4);
  if (field(3) > 1 || head.name_bytes < 2 || head.name_bytes > longest_name) return std::nullopt;
  return head;
}

std::optional<MatrixHead> find_head(std::string_view bytes) {
  const auto head = read_head(bytes, false);
  return head ? head : read_head(bytes, true);
}

}  // namespace

bool is_level4(std::string_view bytes) {
  const auto head = find_head(bytes);
  if (!head || head->rows > 1U << 30U || head->columns > 1U << 30U) return false;
  const std::string_view name = bytes.substr(head_bytes, head->name_bytes);
  if (name.size() < head->name_bytes || name.back() != '\0') return false;
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") ==
         name.size() - 1;
}

void read_level4(std::string_view bytes, MatContents& contents) {
  const std::size_t total = bytes.size();
  while (!bytes.empty()) {
    const std::size_t offset = total - bytes.size();
    const auto head = find_head(bytes);
    const std::uint64_t values = head ? head->rows * head->columns : 0;  // below 2^64: 32 bits each
    const std::size_t size = head ? number_bytes(head->type) : 0;
    const std::size_t left = bytes.size() - (head ? head_bytes : 0);
    const std::uint64_t parts = head && head->is_complex ? 2 : 1;
    const bool fits =
        head && head->name_bytes <= left && values <= (left - head->name_bytes) / (size * parts);
    if (!fits) {
      contents.remark("byte " + std::to_string(offset) + ": cut short or damaged: the rest cannot be read");
      return;
    }
    const std::string_view padded = bytes.substr(head_bytes, head->name_bytes);
    const std::string name(padded.substr(0, padded.find('\0')));
    const std::size_t start = head_bytes + head->name_bytes;
    const MatElement element{head->type, bytes.substr(start, values * size)};
    if (!head->is_full) {
      contents.skip(name, "is text or a sparse array");
    } else if (head->is_complex) {
      contents.skip(name, "is complex; save real(...) and imag(...)");
    } else if (contents.values + values > max_mat_values) {
      contents.skip(name, "is more than fits into memory beside the other variables");
    } else if (values > 0) {
      contents.values += values;
      contents.variables.push_back(
          {name, head->rows, head->columns, numbers_of(element, head->is_big_endian)});
    }
    bytes.remove_prefix(start + values * size * parts);
  }
}

}  // namespace wheelwright::import
