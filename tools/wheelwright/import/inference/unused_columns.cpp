#include "tools/wheelwright/import/inference/unused_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/assignment.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_named = 8;

bool changes(const std::vector<double>& values) {
  const auto is_number = [](double value) { return std::isfinite(value); };
  const auto first = std::ranges::find_if(values, is_number);
  return std::any_of(first, values.end(), [&](double value) { return is_number(value) && value != *first; });
}

const Stream* table_of(std::span<const Recording> recordings, const Mapping& mapping) {
  if (mapping.wheels) return find_channel(recordings, mapping.wheels->left).stream;
  if (mapping.command) return find_channel(recordings, mapping.command->first).stream;
  return nullptr;
}

}  // namespace

bool is_used(const Mapping& mapping, const Stream& stream, const Channel& channel) {
  constexpr std::array columns{"column",
                               "left",
                               "right",
                               "linear",
                               "angular",
                               "throttle",
                               "steering",
                               "left_direction",
                               "right_direction",
                               "x",
                               "y",
                               "theta",
                               "roll",
                               "qx",
                               "qy",
                               "qz",
                               "qw",
                               "velocity",
                               "radius",
                               "curvature"};
  return std::ranges::any_of(mapping_entries(mapping), [&](const MappingEntry& entry) {
    const std::string key = entry.key.substr(entry.key.find('.') + 1);
    return std::ranges::find(columns, key) != columns.end() &&
           channel_of(stream, channel_name(entry.value)) == &channel;
  });
}

std::optional<std::string> unused_columns(std::span<const Recording> recordings, const Mapping& mapping) {
  const Stream* table = table_of(recordings, mapping);
  if (table == nullptr || !table->received_s.empty()) return std::nullopt;
  std::string named;
  std::size_t count = 0;
  for (const Channel& channel : table->channels) {
    if (is_used(mapping, *table, channel) || !changes(channel.values) || is_row_index(channel.values))
      continue;
    if (++count <= max_named) named += (named.empty() ? "" : ", ") + column_in_words(channel);
  }
  if (count == 0) return std::nullopt;
  if (count > max_named) named += " and " + std::to_string(count - max_named) + " more";
  return "not used: " + named;
}

}  // namespace wheelwright::import
