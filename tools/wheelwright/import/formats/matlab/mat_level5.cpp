#include <algorithm>
#include <optional>
#include <utility>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/matlab/mat_element.hpp"
#include "tools/wheelwright/import/formats/matlab/mat_variable.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_depth = 16;
constexpr std::size_t max_fields = 4096;
constexpr std::size_t max_variables = 20'000;
constexpr std::size_t max_inflated_bytes = 2U << 30U;  // of all variables together
constexpr std::size_t max_text = 1000;

enum class ArrayClass : std::uint8_t {
  cell = 1,
  structure = 2,
  object = 3,
  character = 4,
  sparse = 5,
  double_precision = 6,
  uint64 = 15,
  function_handle = 16,
  opaque = 17,
};

struct ArrayHead {
  ArrayClass kind{};
  bool is_complex = false;
  std::size_t rows = 0;
  std::size_t columns = 0;  // of further dimensions too
  std::string name;
};

bool is_numeric(ArrayClass kind) {
  return kind >= ArrayClass::double_precision && kind <= ArrayClass::uint64;
}

std::string class_reason(ArrayClass kind) {
  switch (kind) {
    case ArrayClass::cell:
      return "is a cell array; save its contents as numeric arrays (cell2mat)";
    case ArrayClass::sparse:
      return "is a sparse array; save full(...)";
    case ArrayClass::function_handle:
      return "is a function handle";
    default:
      return "is an array of the unknown class " + std::to_string(static_cast<unsigned>(kind));
  }
}

class Level5Reader {
 public:
  explicit Level5Reader(MatContents& contents) : contents_(contents) {}

  void read(std::string_view bytes) {
    const bool is_big_endian = bytes.substr(126, 2) == "MI";
    const std::string_view body = bytes.substr(header_bytes);
    MatElements elements(body, is_big_endian);
    while (!elements.is_at_end()) {
      const std::size_t offset = bytes.size() - elements.rest().size();
      const auto element = elements.next();
      if (!element) {
        contents_.remark("byte " + std::to_string(offset) + ": cut short, " + element.error() +
                         ": the rest cannot be read");
        return;
      }
      take(*element, is_big_endian, offset);
    }
    if (!elements.rest().empty()) contents_.remark("cut short within the tag of the last variable");
  }

 private:
  void take(const MatElement& element, bool is_big_endian, std::size_t offset) {
    if (element.type == MatType::matrix) {
      array(element.data, is_big_endian, {}, 0);
      return;
    }
    if (element.type != MatType::compressed) {
      contents_.remark("byte " + std::to_string(offset) + ": an element of type " +
                       std::to_string(static_cast<std::uint32_t>(element.type)) +
                       " between the variables, left out");
      return;
    }
    const auto inflated = inflate_element(element.data, max_inflated_bytes - inflated_bytes_);
    if (!inflated) {
      contents_.remark("byte " + std::to_string(offset) + ": a variable cannot be read: " + inflated.error());
      return;
    }
    inflated_bytes_ += inflated->size();
    MatElements within(*inflated, is_big_endian);
    while (!within.is_at_end()) {
      const auto inner = within.next();
      if (!inner) {
        contents_.remark("byte " + std::to_string(offset) +
                         ": a compressed variable cannot be read: " + inner.error());
      } else if (inner->type == MatType::matrix) {
        array(inner->data, is_big_endian, {}, 0);
      }
    }
  }

  // `name`: of the field; empty where the array brings its own.
  void array(std::string_view data, bool is_big_endian, const std::string& name, std::size_t depth) {
    if (data.empty()) return;  // []
    MatElements parts(data, is_big_endian);
    auto head = read_head(parts);
    if (!head) {
      contents_.skip(name.empty() ? "a variable" : name, "has a head that is damaged");
      return;
    }
    if (!name.empty()) head->name = name;
    if (head->name.empty()) return;  // MATLAB keeps the contents of objects under no name
    if (is_numeric(head->kind)) {
      numeric(*head, parts);
    } else if (head->kind == ArrayClass::structure && depth < max_depth) {
      structure(*head, parts, depth);
    } else if (head->kind == ArrayClass::character) {
      characters(*head, parts);
    } else if (head->kind == ArrayClass::object || head->kind == ArrayClass::opaque) {
      contents_.skip(head->name, object_reason(head->kind, parts));
    } else {
      contents_.skip(head->name, class_reason(head->kind));
    }
  }

  // The class has a name of its own; that of newer objects stands behind "MCOS".
  static std::string object_reason(ArrayClass kind, MatElements& parts) {
    if (kind == ArrayClass::opaque) next_of(parts, MatType::int8);
    const auto name = next_of(parts, MatType::int8);
    const std::string of_class = name ? " of class " + config::excerpt(name->data) : "";
    return "is an object" + of_class + "; save its parts as arrays, such as t = ts.Time; x = ts.Data";
  }

  // Flags and class, dimensions, name. Opaque objects have their name in place of the dimensions.
  static std::optional<ArrayHead> read_head(MatElements& parts) {
    const auto flags = next_of(parts, MatType::uint32);
    if (!flags || flags->data.size() < 8) return std::nullopt;
    const std::uint64_t word = unsigned_number(flags->data.substr(0, 4), parts.is_big_endian());
    ArrayHead head;
    head.kind = static_cast<ArrayClass>(word & 0xffU);
    head.is_complex = (word & 0x800U) != 0;
    if (head.kind != ArrayClass::opaque) {
      const auto sizes = next_of(parts, MatType::int32);
      if (!sizes || !read_dimensions(numbers_of(*sizes, parts.is_big_endian()), head)) return std::nullopt;
    }
    const auto name = next_of(parts, MatType::int8);
    if (!name) return std::nullopt;
    head.name = name->data.substr(0, max_text);
    return head;
  }

  static bool read_dimensions(const std::vector<double>& sizes, ArrayHead& head) {
    if (sizes.size() < 2) return false;
    double columns = 1.0;
    for (std::size_t i = 1; i < sizes.size(); ++i) columns *= sizes[i];
    const bool is_possible = sizes[0] >= 0.0 && columns >= 0.0 && sizes[0] < 1e10 && columns < 1e10;
    if (!is_possible) return false;
    head.rows = static_cast<std::size_t>(sizes[0]);
    head.columns = static_cast<std::size_t>(columns);
    return true;
  }

  static std::optional<MatElement> next_of(MatElements& parts, MatType type) {
    if (parts.is_at_end()) return std::nullopt;
    const auto element = parts.next();
    if (!element || element->type != type) return std::nullopt;
    return *element;
  }

  void numeric(const ArrayHead& head, MatElements& parts) {
    if (head.rows == 0 || head.columns == 0) return;
    if (head.is_complex) {
      contents_.skip(head.name, "is complex; save real(...) and imag(...)");
      return;
    }
    const auto element = parts.is_at_end() ? tl::unexpected<std::string>("") : parts.next();
    const std::size_t size = element ? number_bytes(element->type) : 0;
    const std::size_t count = size == 0 ? 0 : element->data.size() / size;
    if (count == 0 || count / head.rows != head.columns || count % head.rows != 0) {
      contents_.skip(head.name, "has " + std::to_string(count) + " values where " +
                                    std::to_string(head.rows) + " x " + std::to_string(head.columns) +
                                    " should be");
      return;
    }
    if (contents_.values + count > max_mat_values || contents_.variables.size() >= max_variables) {
      contents_.skip(head.name, "is more than fits into memory beside the other variables");
      return;
    }
    contents_.values += count;
    contents_.variables.push_back(
        {head.name, head.rows, head.columns, numbers_of(*element, parts.is_big_endian())});
  }

  // Of arrays of structs only what each element holds one after the other: "data(2).left".
  void structure(const ArrayHead& head, MatElements& parts, std::size_t depth) {
    const auto length = next_of(parts, MatType::int32);
    const auto names = next_of(parts, MatType::int8);
    const std::size_t name_bytes = length && length->data.size() >= 4
                                       ? unsigned_number(length->data.substr(0, 4), parts.is_big_endian())
                                       : 0;
    if (!names || name_bytes == 0 || names->data.size() / name_bytes > max_fields) {
      contents_.skip(head.name, "is a struct whose field names are damaged");
      return;
    }
    const std::size_t fields = names->data.size() / name_bytes;
    const std::size_t elements = head.rows * head.columns;
    for (std::size_t i = 0; i < elements && fields > 0; ++i) {
      const std::string prefix = elements == 1 ? head.name : head.name + "(" + std::to_string(i + 1) + ")";
      for (std::size_t field = 0; field < fields; ++field) {
        const auto value = next_of(parts, MatType::matrix);
        if (!value) {
          contents_.skip(head.name, "is a struct that is cut short or damaged");
          return;
        }
        const std::string_view padded = names->data.substr(field * name_bytes, name_bytes);
        array(value->data, parts.is_big_endian(),
              prefix + "." + std::string(padded.substr(0, padded.find('\0'))), depth + 1);
      }
    }
  }

  void characters(const ArrayHead& head, MatElements& parts) {
    if (head.rows != 1 || head.columns > max_text || parts.is_at_end()) return;
    const auto element = parts.next();
    if (!element) return;
    std::string text;
    for (const double code : numbers_of(*element, parts.is_big_endian()))
      text += code >= 32 && code < 256 ? static_cast<char>(static_cast<unsigned char>(code)) : '?';
    if (contents_.texts.size() < max_variables) contents_.texts.emplace_back(head.name, text);
  }

  MatContents& contents_;
  std::size_t inflated_bytes_ = 0;
};

}  // namespace

void MatContents::remark(std::string text) {
  constexpr std::size_t max_remarks = 40;
  if (remarks.size() < max_remarks) remarks.push_back(std::move(text));
}

void MatContents::skip(std::string_view name, std::string_view why) {
  remark("'" + config::excerpt(name) + "' " + std::string(why) + ": left out");
}

void read_level5(std::string_view bytes, MatContents& contents) {
  Level5Reader(contents).read(bytes);
}

}  // namespace wheelwright::import
