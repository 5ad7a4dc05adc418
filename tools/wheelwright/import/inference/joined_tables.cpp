#include "tools/wheelwright/import/inference/joined_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/join_streams.hpp"

namespace wheelwright::import {
namespace {

constexpr double min_evenness = 0.3;  // of a clock
constexpr std::size_t min_joined_rows = 20;

bool has_clock_and_no_names(const Stream& stream) {
  if (stream.name.empty() || !stream.received_s.empty() || stream.channels.size() < 2 ||
      stream.rows < min_joined_rows)
    return false;
  const bool has_names = std::ranges::any_of(stream.channels, [](const Channel& channel) {
    return !std::ranges::all_of(channel.name, config::is_digit);
  });
  return !has_names && evenness(stream.channels.front().values) > min_evenness;
}

}  // namespace

std::optional<Stream> joined_tables(std::span<const Recording> recordings) {
  std::vector<const Stream*> tables;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams)
      if (has_clock_and_no_names(stream)) tables.push_back(&stream);
  }
  if (tables.size() < 2) return std::nullopt;
  // At the rows of counts, whose speeds are not to be those of a staircase.
  const auto is_counted = [](const Stream& table) {
    return meaning_of(Stream{}, Channel{table.name + ":2", {}, {}}).quantity == Quantity::count;
  };
  const Stream& longest = **std::ranges::max_element(
      tables, {}, [&](const Stream* table) { return std::pair(is_counted(*table), table->rows); });
  const std::vector<double>& clock = longest.channels.front().values;
  Stream joined;
  joined.rows = longest.rows;
  joined.places = longest.places;
  joined.channels.push_back(longest.channels.front());
  for (const Stream* table : tables) {
    for (std::size_t k = 1; k < table->channels.size(); ++k) {
      const Channel& channel = table->channels[k];
      Channel named{table->name + ":" + channel.name, channel.unit, channel.values};
      if (table != &longest) {
        named.values = join(table->channels.front().values, channel.values, clock, Joining::held);
        double last = named.values.empty() ? nothing : channel.values.front();
        for (double& value : named.values) {
          if (!std::isfinite(value)) value = last;
          last = value;
        }
      }
      joined.channels.push_back(std::move(named));
    }
  }
  return joined;
}

}  // namespace wheelwright::import
