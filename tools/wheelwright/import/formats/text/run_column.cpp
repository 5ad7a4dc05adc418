#include "tools/wheelwright/import/formats/text/run_column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "config/load/ascii_text.hpp"
#include "config/load/printable_text.hpp"

namespace wheelwright::import {
namespace {

// Small words, parted at all that is no letter and where a capital follows a small letter.
std::vector<std::string> letters_of(std::string_view name) {
  std::vector<std::string> words(1);
  char before = ' ';
  for (const char character : name) {
    const bool is_capital = character >= 'A' && character <= 'Z';
    const bool is_letter = is_capital || (character >= 'a' && character <= 'z');
    const bool begins = is_capital && before >= 'a' && before <= 'z';
    if ((!is_letter || begins) && !words.back().empty()) words.emplace_back();
    if (is_letter) words.back() += config::to_lower(character);
    before = character;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// The first row of each stretch of one value.
std::vector<std::size_t> stretch_starts(const std::vector<double>& values) {
  std::vector<std::size_t> starts;
  double last = nothing;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || values[i] == last) continue;
    starts.push_back(starts.empty() ? 0 : i);
    last = values[i];
  }
  return starts;
}

// "run" that goes from 0 to 1 once may say that the robot runs.
bool may_be_flag(const Channel& channel) {
  return letters_of(channel.name).size() == 1 &&
         std::ranges::all_of(channel.values, [](double value) { return value == 0.0 || value == 1.0; });
}

}  // namespace

bool names_a_run(std::string_view name) {
  constexpr std::array<std::string_view, 14> runs{"run",  "runs",       "trial",   "session",  "episode",
                                                  "test", "experiment", "exp",     "take",     "rep",
                                                  "lap",  "repetition", "attempt", "recording"};
  constexpr std::array<std::string_view, 8> numbers{"id",     "no",  "nr",    "num",
                                                    "number", "idx", "index", "name"};
  const auto words = letters_of(name);
  const auto is_run = [&](const std::string& word) { return std::ranges::find(runs, word) != runs.end(); };
  return std::ranges::any_of(words, is_run) && std::ranges::all_of(words, [&](const std::string& word) {
           return is_run(word) || std::ranges::find(numbers, word) != numbers.end();
         });
}

bool are_stretches(const std::vector<double>& values) {
  const auto starts = stretch_starts(values);
  std::set<double> seen;
  for (const std::size_t start : starts) {
    const auto value = std::find_if(values.begin() + static_cast<std::ptrdiff_t>(start), values.end(),
                                    [](double each) { return std::isfinite(each); });
    if (!seen.insert(*value).second) return false;
  }
  constexpr std::size_t min_rows = 10;  // of a run, on average
  return starts.size() > 1 && min_rows * starts.size() <= values.size();
}

void find_runs(Stream& stream, std::vector<std::string>& remarks) {
  if (!stream.run_starts.empty()) return;
  for (const Channel& channel : stream.channels) {
    if (!names_a_run(channel.name) || may_be_flag(channel) || !are_stretches(channel.values)) continue;
    stream.run_starts = stretch_starts(channel.values);
    remarks.push_back("column '" + config::excerpt(channel.name) + "' tells " +
                      std::to_string(stream.run_starts.size()) + " runs apart: each is a run of its own");
    return;
  }
}

}  // namespace wheelwright::import
