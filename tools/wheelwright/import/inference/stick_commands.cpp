#include "tools/wheelwright/import/inference/stick_commands.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/wheel_directions.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t max_axes = 8;

struct Sticks {
  CommandKind kind = CommandKind::throttle;
  ChannelName first;
  std::optional<ChannelName> second;
};

CommandMapping command_of(const Sticks& sticks) {
  CommandMapping command;
  command.kind = sticks.kind;
  command.first = sticks.first;
  command.second = sticks.second;
  return command;
}

bool is_vertical(const Named& axis) {
  return NameWords(axis.channel->name)
      .has_any({"y", "vertical", "throttle", "linear", "lin", "forward", "fwd", "drive", "speed"});
}

bool is_horizontal(const Named& axis) {
  return NameWords(axis.channel->name)
      .has_any(
          {"x", "horizontal", "angular", "ang", "turn", "turning", "steer", "steering", "rotation", "yaw"});
}

// Those of the first stream that has any, and that are moved.
std::vector<Named> moved_axes(const NamedChannels& named) {
  std::vector<Named> axes;
  for (const Named& each : named.list()) {
    if (each.meaning.quantity != Quantity::stick || !(range_of(each.channel->values).size() > 0.0)) continue;
    if ((axes.empty() || axes.front().stream == each.stream) && axes.size() < max_axes) axes.push_back(each);
  }
  return axes;
}

std::optional<Sticks> by_names(const std::vector<Named>& axes) {
  const Named* left = nullptr;
  const Named* right = nullptr;
  const Named* drives = nullptr;
  const Named* turns = nullptr;
  for (const Named& axis : axes) {
    if (is_vertical(axis)) {
      if (drives == nullptr) drives = &axis;
      (axis.meaning.side == NamedSide::right ? right : left) = &axis;
    } else if (is_horizontal(axis) && turns == nullptr) {
      turns = &axis;
    }
  }
  const bool has_sides = left != nullptr && right != nullptr && left->meaning.side == NamedSide::left;
  if (has_sides) return Sticks{CommandKind::duty, left->name(), right->name()};
  if (drives == nullptr || turns == nullptr) return std::nullopt;
  return Sticks{CommandKind::throttle, drives->name(), turns->name()};
}

std::array<ResponseFit, 2> fits_of(std::span<const Recording> recordings, Mapping mapping,
                                   const CommandMapping& command) {
  mapping.command = command;
  const auto columns = gather_sample(recordings, mapping);
  if (!columns) return {};
  const auto rows = response_rows(*columns, mapping);
  return {fit_response(rows[0]), fit_response(rows[1])};
}

// The axis that explains each of two speeds best: of the wheels, or of the body.
std::optional<Sticks> best_of_kind(std::span<const Recording> recordings, const Mapping& mapping,
                                   const std::vector<Named>& axes, CommandKind kind, double& explained) {
  std::array<double, 2> most{};
  std::array<const Named*, 2> best{};
  for (const Named& axis : axes) {
    const auto fits = fits_of(recordings, mapping, command_of({kind, axis.name(), axis.name()}));
    for (std::size_t k = 0; k < 2; ++k) {
      if (fits[k].explained <= most[k]) continue;
      most[k] = fits[k].explained;
      best[k] = &axis;
    }
  }
  explained = std::min(most[0], most[1]);
  if (best[0] == nullptr || best[1] == nullptr || best[0] == best[1]) return std::nullopt;
  return Sticks{kind, best[0]->name(), best[1]->name()};
}

std::optional<Sticks> by_motion(std::span<const Recording> recordings, const Mapping& mapping,
                                const std::vector<Named>& axes) {
  double of_body = 0.0;
  double of_wheels = 0.0;
  auto body = best_of_kind(recordings, mapping, axes, CommandKind::throttle, of_body);
  const auto wheels = best_of_kind(recordings, mapping, axes, CommandKind::duty, of_wheels);
  if (body && of_body >= unit_explained && (!wheels || of_body >= of_wheels)) return body;
  return wheels && of_wheels >= unit_explained ? wheels : std::nullopt;
}

bool goes_backward(const std::array<ResponseFit, 2>& fits, CommandKind kind) {
  const auto is_against = [](const ResponseFit& fit) {
    return fit.explained >= unit_explained && fit.gain < 0.0;
  };
  return is_against(fits[0]) && (kind == CommandKind::throttle || is_against(fits[1]));
}

}  // namespace

void find_stick_commands(std::span<const Recording> recordings, Mapping& mapping,
                         std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  if (mapping.command) return;
  const auto axes = moved_axes(NamedChannels(recordings, mapping));
  const bool has_both = mapping.wheels && mapping.wheels->right;
  auto sticks = by_names(axes);
  if (!sticks && has_both) sticks = by_motion(recordings, mapping, axes);
  if (!sticks) return;
  mapping.command = command_of(*sticks);
  const bool is_body = sticks->kind == CommandKind::throttle;
  findings.push_back("commands are the axes of a stick: " + sticks->first.text() +
                     (is_body ? " drives and " : " is the left wheel and ") + sticks->second->text() +
                     (is_body ? " turns" : " the right one"));
  if (!has_both) {
    doubts.emplace_back(
        "no wheels show which way a stick is forward; its positive numbers are taken: --set "
        "command.reversed=both if -1 is");
    return;
  }
  if (!goes_backward(fits_of(recordings, mapping, *mapping.command), sticks->kind)) return;
  mapping.command->left_reversed = mapping.command->right_reversed = true;
  findings.push_back("-1 of " + sticks->first.text() +
                     " is forward: the wheels count up with it; --set command.reversed=none if they count "
                     "backwards");
}

}  // namespace wheelwright::import
