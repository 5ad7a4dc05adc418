#include "tools/wheelwright/import/inference/body_choice.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/conversion/clock_shift.hpp"
#include "tools/wheelwright/import/inference/infer_mapping.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_bodies = 16;

bool has(const Stream& stream, Quantity quantity) {
  return std::ranges::any_of(stream.channels, [&](const Channel& channel) {
    return meaning_of(stream, channel).quantity == quantity;
  });
}

bool is_body(const Stream& stream) {
  return has(stream, Quantity::x) && has(stream, Quantity::y) && !has(stream, Quantity::count) &&
         !has(stream, Quantity::command) && !has(stream, Quantity::duty) &&
         !has(stream, Quantity::linear_command);
}

bool holds_bodies(const Recording& recording) {
  return recording.streams.size() > 1 && recording.streams.size() <= max_bodies &&
         std::ranges::all_of(recording.streams, is_body);
}

// Correlation of the speed of one body and of the robot.
double agreement(std::vector<Recording> recordings, std::size_t at, std::size_t body,
                 const GivenMapping& given) {
  Stream only = std::move(recordings[at].streams[body]);
  recordings[at].streams.clear();
  recordings[at].streams.push_back(std::move(only));
  const Inference inference = infer_mapping(recordings, given);
  const Mapping mapping = to_mapping(inference.entries, recordings[at].name);
  if (!mapping.reference || !mapping.reference->x || (!mapping.wheels && !mapping.command)) return 0.0;
  const auto shift = find_clock_shift(recordings, mapping);
  return shift ? shift->correlation : 0.0;
}

}  // namespace

std::optional<std::string> choose_among_bodies(std::vector<Recording>& recordings,
                                               const GivenMapping& given) {
  constexpr double clear_lead = 0.1;
  const auto found = std::ranges::find_if(recordings, holds_bodies);
  if (found == recordings.end() || recordings.size() < 2 || given.says("reference.x")) return std::nullopt;
  const auto at = static_cast<std::size_t>(found - recordings.begin());
  std::vector<double> agreements;
  for (std::size_t body = 0; body < found->streams.size(); ++body)
    agreements.push_back(agreement(recordings, at, body, given));
  const auto best = std::ranges::max_element(agreements);
  double next = 0.0;
  for (auto other = agreements.begin(); other != agreements.end(); ++other)
    if (other != best) next = std::max(next, *other);
  if (*best < next + clear_lead) return std::nullopt;
  Stream only = std::move(found->streams[static_cast<std::size_t>(best - agreements.begin())]);
  std::string line = "of " + std::to_string(agreements.size()) + " bodies in " + found->name + ", '" +
                     config::excerpt(only.name) + "' moves as the robot does (correlation " +
                     config::fixed_number(*best, 2) + "; the next one " + config::fixed_number(next, 2) + ")";
  found->streams.clear();
  found->streams.push_back(std::move(only));
  return line;
}

}  // namespace wheelwright::import
