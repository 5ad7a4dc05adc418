// A text field of a message that may be the same in all of them, such as a frame's name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace wheelwright::import::ros {

struct ConstantText {
  explicit ConstantText(std::string field_name) : name(std::move(field_name)) {}

  void see(std::string_view text) {
    last = text;
    if (!is_seen) first = text.substr(0, longest);
    is_constant = is_constant && (!is_seen || text == first);
    is_seen = true;
  }

  static constexpr std::size_t longest = 200;
  std::string name;  // "header.frame_id"
  std::string first;
  std::string_view last;  // of the message at hand; valid as long as that is
  bool is_seen = false;
  bool is_constant = true;
};

}  // namespace wheelwright::import::ros
