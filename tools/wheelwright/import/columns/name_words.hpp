// The words of a name, in lower case: "posL" is pos, l; "CMD_LEFT" is cmd, left; "twist.linear.x" is twist,
// linear, x; "encl" is enc, l.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::import {

class NameWords {
 public:
  explicit NameWords(std::string_view name);

  const std::vector<std::string>& words() const { return words_; }
  bool empty() const { return words_.empty(); }
  bool has(std::string_view word) const;
  bool has_any(std::initializer_list<std::string_view> words) const;
  std::string_view last() const { return words_.empty() ? std::string_view() : words_.back(); }
  // Takes the unit off the end, "m", "s" of "speed_m_s"; returns it in its standard spelling, or empty.
  std::string take_unit();

 private:
  std::vector<std::string> words_;
};

// Whether a name is that of a register of a servo: "goal_velocity", "present_speed".
bool names_a_register(std::string_view name);

}  // namespace wheelwright::import
