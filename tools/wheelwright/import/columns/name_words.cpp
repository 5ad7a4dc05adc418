#include "tools/wheelwright/import/columns/name_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::is_digit;
using std::string_view;

bool is_upper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}
bool is_lower(char c) {
  return std::islower(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Before which a side may stand as one letter: "vr", "encl", "rpmr".
constexpr std::array<string_view, 29> before_side{
    "v",     "w",     "u",     "n",     "s",     "d",   "m",   "enc",   "pwm",  "pos",
    "vel",   "tick",  "ticks", "cmd",   "count", "rpm", "phi", "th",    "dist", "speed",
    "motor", "wheel", "duty",  "omega", "spd",   "sp",  "set", "pulse", "volt"};

// Behind which one letter is a side: "lwheel", "rmotor".
constexpr std::array<string_view, 8> behind_side{"wheel", "motor", "enc",    "encoder",
                                                 "tick",  "ticks", "wheels", "count"};

// A word begins at a capital behind a small letter, at a capital before a small letter, and where letters and
// digits meet.
bool begins_word(string_view name, std::size_t at) {
  const char c = name[at];
  const char before = name[at - 1];
  if (is_upper(c) && is_lower(before)) return true;
  if (is_upper(c) && is_upper(before) && at + 1 < name.size() && is_lower(name[at + 1])) return true;
  return is_letter(c) != is_letter(before) && (is_digit(c) || is_digit(before));
}

void add_word(std::vector<std::string>& words, std::string word) {
  if (word.empty()) return;
  const char last = word.back();
  const string_view front(word.data(), word.size() - 1);
  if ((last == 'l' || last == 'r') && std::ranges::find(before_side, front) != before_side.end()) {
    words.emplace_back(front);
    words.emplace_back(1, last);
    return;
  }
  const char first = word.front();
  const string_view behind(word.data() + 1, word.size() - 1);
  if ((first == 'l' || first == 'r') && std::ranges::find(behind_side, behind) != behind_side.end()) {
    words.emplace_back(1, first);
    words.emplace_back(behind);
    return;
  }
  for (const string_view side : {"left", "right"}) {  // "leftwheel", "wheelleft"
    if (word.size() > side.size() && word.starts_with(side)) {
      words.emplace_back(side);
      words.push_back(word.substr(side.size()));
      return;
    }
    if (word.size() > side.size() && word.ends_with(side)) {
      words.push_back(word.substr(0, word.size() - side.size()));
      words.emplace_back(side);
      return;
    }
  }
  words.push_back(std::move(word));
}

}  // namespace

NameWords::NameWords(string_view name) {
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool belongs = is_letter(c) || is_digit(c) || c == '/' || static_cast<unsigned char>(c) >= 0x80;
    if (!belongs || c == '/' || (i > 0 && !word.empty() && begins_word(name, i))) {
      add_word(words_, std::move(word));
      word.clear();
    }
    if (belongs && c != '/') word += config::to_lower(c);
  }
  add_word(words_, std::move(word));
}

bool NameWords::has(string_view word) const {
  return std::ranges::find(words_, word) != words_.end();
}

bool NameWords::has_any(std::initializer_list<string_view> words) const {
  return std::ranges::any_of(words, [this](string_view word) { return has(word); });
}

std::string NameWords::take_unit() {
  // Also with the side within: "ticks_left_per_s".
  if (has("per") && has_any({"s", "sec", "second"}) &&
      has_any({"tick", "ticks", "count", "counts", "pulse", "pulses"}))
    return "counts/s";
  for (const std::size_t count : {std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
    if (words_.size() <= count && !(count == 1 && words_.size() == 1 && words_[0] == "rpm")) continue;
    std::string ending;
    std::string joined;  // "batt_mV" has the words m and v
    for (std::size_t i = words_.size() - count; i < words_.size(); ++i) {
      ending += (ending.empty() ? "" : "_") + words_[i];
      joined += words_[i];
    }
    if (count == 2 && joined == "mv") ending = joined;
    // "cmd_v" is a speed; "battery_v" is in volts.
    if (ending == "v" && !has_any({"battery", "bat", "batt", "voltage", "vbat", "supply"})) continue;
    if (ending == "ms" || ending == "us" || ending == "ns" || ending == "s") {
      words_.resize(words_.size() - 1);
      return ending;
    }
    const string_view unit = unit_by_spelling(ending);
    const bool is_measured = has_any({"pos", "position", "angle", "dist", "distance", "travel", "enc",
                                      "encoder", "vel", "velocity", "speed", "x", "y", "odo"});
    if (ending == "in" && is_measured) {
      words_.resize(words_.size() - 1);
      return "inch";
    }
    // "joy_turn" is no unit, and "left_rev" may be a direction.
    if (unit.empty() || ending == "turn" || (ending == "rev" && !is_measured)) continue;
    if (unit == pixel_unit && !has_any({"x", "y", "cx", "cy", "pos", "width"})) continue;  // "pose_px"
    if (words_.size() > count) words_.resize(words_.size() - count);
    return std::string(unit);
  }
  // Anywhere, where it can be nothing else: "target_rpm_left".
  for (const string_view word : {"rpm", "rps", "dps", "mps", "mmps", "cmps", "radps", "degps", "kmh", "kph",
                                 "deg", "degrees", "cps", "qpps"}) {
    if (has(word)) return std::string(unit_by_spelling(word));
  }
  return {};
}

bool names_a_register(std::string_view name) {
  const NameWords words(name);
  return words.has_any({"goal", "present", "moving"}) && words.has_any({"velocity", "speed"});
}

}  // namespace wheelwright::import
