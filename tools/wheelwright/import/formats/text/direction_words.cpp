#include "tools/wheelwright/import/formats/text/direction_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include "config/load/printable_text.hpp"

namespace wheelwright::import {
namespace {

constexpr std::array<std::string_view, 7> forward_words{"f",        "fw",    "fwd", "forward",
                                                        "forwards", "ahead", "cw"};
constexpr std::array<std::string_view, 13> backward_words{
    "b", "r", "bw", "bwd", "back", "backward", "backwards", "rev", "reverse", "rv", "rw", "ccw", "bk"};
constexpr std::array<std::string_view, 10> standing_words{"s",       "stop", "stopped", "brake", "coast",
                                                          "release", "idle", "none",    "off",   "n"};

std::optional<double> direction_of(const std::string& text) {
  std::string word = text;
  std::ranges::transform(word, word.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  const auto is_one_of = [&](const auto& words) { return std::ranges::find(words, word) != words.end(); };
  if (is_one_of(forward_words)) return 1.0;
  if (is_one_of(backward_words)) return -1.0;
  if (is_one_of(standing_words)) return 0.0;
  return std::nullopt;
}

// One for each label; empty where these are no directions.
std::vector<double> directions_of(const Labels& labels) {
  std::vector<double> directions;
  if (labels.are_too_many()) return directions;
  for (const std::string& name : labels.names()) {
    const auto direction = direction_of(name);
    if (!direction) return {};
    directions.push_back(*direction);
  }
  const auto has = [&](double way) { return std::ranges::find(directions, way) != directions.end(); };
  return has(1.0) && has(-1.0) ? directions : std::vector<double>{};
}

}  // namespace

void read_direction_words(TextTable& table, std::vector<std::string>& remarks) {
  for (std::size_t i = 0; i < table.width(); ++i) {
    if (table.columns[i].kind != ColumnKind::text) continue;
    const std::vector<double> directions = directions_of(table.labels[i]);
    if (directions.empty()) continue;
    std::string words;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      words += (k > 0 ? ", " : "") + std::string("'") + config::excerpt(table.labels[i].names()[k]) +
               "' is " +
               (directions[k] > 0.0   ? "1"
                : directions[k] < 0.0 ? "-1"
                                      : "0");
    }
    remarks.push_back("column '" + config::excerpt(table.columns[i].name) + "' holds directions: " + words);
    for (double& value : table.values[i]) {
      if (std::isfinite(value)) value = directions[static_cast<std::size_t>(value)];
    }
    table.columns[i].kind = ColumnKind::number;
  }
}

}  // namespace wheelwright::import
