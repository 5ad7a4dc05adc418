// What options of every program take, said in one line where it is something else: which words, or which
// numbers. CLI11's own checks tell of words by their inner numbers, and let NaN pass.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {

// For Option::transform: one of these words, for the value beside it.
template <typename Enum>
CLI::Validator one_of(std::vector<std::pair<std::string, Enum>> words) {
  std::string choices;
  std::string said;
  for (std::size_t i = 0; i < words.size(); ++i) {
    choices += (i == 0 ? "" : ",") + words[i].first;
    said += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i].first;
  }
  const auto translate = [words = std::move(words), said](std::string& word) -> std::string {
    for (const auto& [known, value] : words) {
      if (word != known) continue;
      word = std::to_string(static_cast<std::underlying_type_t<Enum>>(value));
      return "";
    }
    return "is '" + word + "', but must be " + said;
  };
  return {translate, "{" + choices + "}"};
}

// For Option::check: a number within bounds, which NaN is not.
inline CLI::Validator number_between(double least, double most, const std::string& unit) {
  const std::string range =
      "from " + config::plain_number(least) + " to " + config::plain_number(most) + " " + unit;
  const auto check = [least, most, range](const std::string& word) -> std::string {
    double value = 0.0;
    const bool is_number = CLI::detail::lexical_cast(word, value);
    if (is_number && value >= least && value <= most) return "";
    return "is '" + word + "', but must be a number " + range;
  };
  return {check, range};
}

}  // namespace wheelwright::tools
