// The variables of a MATLAB file as they come out of its bytes, before they are sorted into streams.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wheelwright::import {

// A real numeric array, in the order of the file: column by column.
struct MatVariable {
  std::string name;  // "data.left" of a field
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;
};

struct MatContents {
  std::vector<MatVariable> variables;
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::string> remarks;
  std::size_t values = 0;  // in all, to bound the memory

  void remark(std::string text);
  // Says why a variable is not read.
  void skip(std::string_view name, std::string_view why);
};

// Values of all variables together: 1.3 GB.
inline constexpr std::size_t max_mat_values = 160'000'000;

inline constexpr std::size_t header_bytes = 128;

// Level 5: the elements behind the header.
void read_level5(std::string_view bytes, MatContents& contents);
// Level 4: matrices one behind the other.
void read_level4(std::string_view bytes, MatContents& contents);
bool is_level4(std::string_view head);

}  // namespace wheelwright::import
