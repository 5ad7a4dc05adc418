#include "tools/wheelwright/import/inference/command_rivals.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"

namespace wheelwright::import {
namespace {

constexpr double sure_nats = 20.0;

bool means_the_same(const NameMeaning& one, const NameMeaning& other) {
  return one.quantity == other.quantity && one.side == other.side;
}

// The channels of a stream that mean what `meaning` says.
std::vector<const Channel*> like(const Stream& stream, const NameMeaning& meaning) {
  std::vector<const Channel*> found;
  for (const Channel& channel : stream.channels)
    if (means_the_same(meaning_of(stream, channel), meaning)) found.push_back(&channel);
  return found;
}

std::vector<CommandMapping> rivals_of(std::span<const Recording> recordings, const CommandMapping& command) {
  const FoundChannel first = find_channel(recordings, command.first);
  const FoundChannel second = find_channel(recordings, *command.second);
  if (first.channel == nullptr || second.channel == nullptr || first.stream != second.stream) return {};
  // Columns that are called by their numbers are alike in that they have no names.
  if (meaning_of(*first.stream, *first.channel).quantity == Quantity::unknown) return {};
  std::vector<CommandMapping> rivals;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      const auto others = like(stream, meaning_of(*second.stream, *second.channel));
      if (others.empty() || (&stream != first.stream && stream.name.empty())) continue;
      for (const Channel* one : like(stream, meaning_of(*first.stream, *first.channel))) {
        const Channel* other = *std::ranges::min_element(
            others, {}, [&](const Channel* each) { return words_apart(one->name, each->name); });
        if (one == first.channel || other == second.channel) continue;
        rivals.push_back(command);
        rivals.back().first = {stream.name, one->name};
        rivals.back().second = ChannelName{stream.name, other->name};
      }
    }
  }
  return rivals;
}

struct Explained {
  double share = 0.0;
  double nats = 0.0;
};

Explained explained_by(std::span<const Recording> recordings, Mapping mapping,
                       const CommandMapping& command) {
  mapping.command = command;
  const auto columns = gather_sample(recordings, mapping);
  if (!columns) return {};
  const auto rows = response_rows(*columns, mapping);
  const ResponseFit first = fit_response(rows[0]);
  const ResponseFit second = fit_response(rows[1]);
  return {std::max(first.explained, second.explained), first.nats + second.nats};
}

std::string in_percent(double share) {
  return config::fixed_number(100.0 * share, 1) + " %";
}

}  // namespace

void choose_among_commands(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                           std::vector<std::string>& findings) {
  const bool is_given = std::ranges::any_of(
      std::array{"command.left", "command.linear", "command.velocity", "command.throttle"},
      [&given](const char* key) { return given.says(key); });
  if (is_given || !mapping.command || !mapping.wheels || !mapping.command->second) return;
  const auto rivals = rivals_of(recordings, *mapping.command);
  if (rivals.empty()) return;
  const CommandMapping before = *mapping.command;
  const Explained of_first = explained_by(recordings, mapping, before);
  const CommandMapping* best = &before;
  Explained most = of_first;
  for (const CommandMapping& rival : rivals) {
    const Explained found = explained_by(recordings, mapping, rival);
    if (found.nats <= (best == &before ? most.nats + sure_nats : most.nats)) continue;
    best = &rival;
    most = found;
  }
  if (best == &before) return;
  std::erase_if(findings, [&before](const std::string& finding) {
    return finding.starts_with(before.first.text() + " was taken; there are also");
  });
  mapping.command = *best;
  findings.push_back("the commands are " + best->first.text() + ", which explain " + in_percent(most.share) +
                     " of the speed of the wheels; " + before.first.text() + " explain " +
                     in_percent(of_first.share));
}

}  // namespace wheelwright::import
