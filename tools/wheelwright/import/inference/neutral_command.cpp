#include "tools/wheelwright/import/inference/neutral_command.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"

namespace wheelwright::import {
namespace {

constexpr double more_than_alone_nats = 50.0;
constexpr double min_neutral_explained = 0.5;
constexpr double nearness = 0.1;       // of the range of the commands
constexpr std::size_t rest_rows = 10;  // of wheels that stand, with one command

// What the commands of one channel say, with the motion that follows it.
struct Evidence {
  double neutral = 0.0;
  double nats = 0.0;  // over a response alone
};

ValueRange range_of_both(const std::array<Column, 2>& commands) {
  const ValueRange first = range_of(commands[0]);
  const ValueRange second = range_of(commands[1]);
  return {std::min(first.least, second.least), std::max(first.most, second.most)};
}

bool are_all_whole(const std::array<Column, 2>& commands) {
  return std::ranges::all_of(commands, [](const Column& column) { return are_whole(column); });
}

// The command at which the wheels most often stand, where it has not changed for as long as a robot answers.
std::optional<double> command_at_rest(std::span<const ResponseRows> sides) {
  std::map<double, std::size_t> counts;
  for (const ResponseRows& side : sides) {
    std::size_t still = 0;
    for (std::size_t i = 1; i < side.speed.size(); ++i) {
      const bool is_still = side.speed[i] == 0.0 && side.command[i] == side.command[i - 1];
      still = is_still ? still + 1 : 0;
      if (still >= rest_rows) ++counts[side.command[i]];
    }
  }
  const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  return most == counts.end() ? std::nullopt : std::optional(most->first);
}

// Where the line from command to speed has no speed, over the sides on which it is known.
std::optional<Evidence> by_constant(std::span<const ResponseRows> sides) {
  Evidence sum;
  double weight = 0.0;
  for (const ResponseRows& side : sides) {
    const ResponseFit with = fit_response(side, Baseline::any);
    if (with.explained < min_neutral_explained || with.gain == 0.0) continue;
    sum.nats += with.nats - fit_response(side).nats;
    sum.neutral += with.nats * -with.at_zero / with.gain;
    weight += with.nats;
  }
  if (!(weight > 0.0) || sum.nats < more_than_alone_nats) return std::nullopt;
  sum.neutral /= weight;
  return sum;
}

// Of wheels whose counters never fall: how much better the distance of the commands from `neutral` explains
// their speed.
std::optional<Evidence> by_size(std::span<const ResponseRows> sides, double neutral) {
  Evidence sum{neutral, 0.0};
  for (const ResponseRows& side : sides) {
    if (std::ranges::any_of(side.speed, [](double speed) { return speed < 0.0; })) return std::nullopt;
    ResponseRows sizes = side;
    for (double& command : sizes.command) command = std::abs(command - neutral);
    const ResponseFit fit = fit_response(sizes);
    if (fit.explained < min_neutral_explained) return std::nullopt;
    sum.nats += fit.nats - fit_response(side, Baseline::any).nats;
  }
  if (sum.nats < more_than_alone_nats) return std::nullopt;
  return sum;
}

// A number that people choose, if one is near; else a whole number of whole commands.
double likely_neutral(double estimate, double near, bool is_whole) {
  constexpr std::array chosen{0.5, 50.0, 90.0, 127.0, 128.0, 500.0, 512.0, 1500.0, 2048.0, 32768.0};
  const double closest = *std::ranges::min_element(
      chosen, {}, [estimate](double number) { return std::abs(number - estimate); });
  if (std::abs(closest - estimate) <= near) return closest;
  return is_whole ? std::round(estimate) : estimate;
}

std::optional<Evidence> find_neutral(const DriveColumns& columns, const Mapping& mapping) {
  const ValueRange range = range_of_both(columns.command);
  if (!(range.least >= 0.0) || !(range.size() > 0.0)) return std::nullopt;
  const auto both = response_rows(columns, mapping);
  const bool is_one = columns.command[1].empty() && columns.wheel[1].empty();
  const std::span<const ResponseRows> sides(both.data(), is_one || mapping.command->is_of_body() ? 1 : 2);
  const auto rest = command_at_rest(sides);
  const double near = nearness * range.size();
  if (auto found = by_constant(sides)) {
    if (rest && std::abs(*rest - found->neutral) <= near) {
      found->neutral = *rest;
      return found;
    }
    if (!rest && found->neutral >= range.least + near && found->neutral <= range.most - near) {
      found->neutral = likely_neutral(found->neutral, 0.5 * near, are_all_whole(columns.command));
      return found;
    }
  }
  if (!rest || *rest < range.least + near || *rest > range.most - near) return std::nullopt;
  return by_size(sides, *rest);
}

}  // namespace

void infer_neutral(DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings) {
  if (!mapping.command || !mapping.wheels || given.says("command.neutral") || mapping.command->direction[0])
    return;
  reverse_commands(columns, *mapping.command);  // as the file has them
  const auto found = find_neutral(columns, mapping);
  if (found) subtract_neutral(columns, found->neutral);
  reverse_commands(columns, *mapping.command);
  if (!found || found->neutral == 0.0) return;
  mapping.command->neutral = found->neutral;
  findings.push_back("the wheels rest at a command of " + config::plain_number(found->neutral) +
                     " (log-likelihood gain over 0: " + config::fixed_number(found->nats, 0) + ")");
}

}  // namespace wheelwright::import
