#include "tools/wheelwright/import/conversion/stamp_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"

namespace wheelwright::import {
namespace {

// The name without its last word, if that is one of `words`.
std::optional<std::string> stem(const std::string& name, std::initializer_list<std::string_view> words) {
  const NameWords parts(name);
  if (parts.empty() || std::ranges::find(words, parts.last()) == words.end()) return std::nullopt;
  std::string joined;
  for (std::size_t i = 0; i + 1 < parts.words().size(); ++i) joined += parts.words()[i] + " ";
  return joined;
}

}  // namespace

void join_seconds_and_nanoseconds(Stream& stream) {
  constexpr double nanosecond_s = 1e-9;
  for (Channel& seconds : stream.channels) {
    const auto first = stem(seconds.name, {"sec", "secs", "seconds", "s"});
    if (!first || !are_whole(seconds.values)) continue;
    const auto rest = std::ranges::find_if(stream.channels, [&](const Channel& channel) {
      return stem(channel.name, {"nanosec", "nanosecs", "nsec", "nsecs", "nanoseconds"}) == first;
    });
    if (rest == stream.channels.end()) continue;
    for (std::size_t row = 0; row < seconds.values.size(); ++row)
      seconds.values[row] += nanosecond_s * rest->values[row];
    seconds.unit = "s";
    stream.channels.erase(rest);
    return;
  }
}

void sum_steps_of_time(Stream& stream) {
  if (std::ranges::any_of(stream.channels, [&stream](const Channel& channel) {
        return meaning_of(stream, channel).quantity == Quantity::time;
      }))
    return;
  const auto steps = std::ranges::find_if(stream.channels, [](const Channel& channel) {
    const NameWords words(channel.name);
    return !words.empty() && (words.words().front() == "dt" || words.words().front() == "deltat") &&
           words.words().size() <= 2 &&
           std::ranges::all_of(channel.values, [](double step) { return step >= 0.0; });
  });
  if (steps == stream.channels.end()) return;
  double sum = 0.0;
  for (double& value : steps->values) {
    sum += value;
    value = sum;
  }
  steps->name = "time (sum of " + steps->name + ")";
}

}  // namespace wheelwright::import
