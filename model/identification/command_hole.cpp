#include "model/identification/command_hole.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheelwright {
namespace {

constexpr std::size_t min_commands = 3;
constexpr std::size_t min_beside = 2;
constexpr double max_still = 0.25;   // of its command, the speed of a wheel that stands
constexpr double min_moving = 0.5;   // and of one that moves
constexpr double sure_errors = 2.0;  // standard errors by which either has to be so

struct Held {
  double size_m_s;
  bool is_still;
};

// Those that are surely the one or the other, by their size.
std::vector<Held> sorted_commands(const SteadyStateSpeeds& speeds) {
  std::vector<Held> commands;
  for (const auto* wheel : {&speeds.left, &speeds.right}) {
    for (const auto& held : *wheel) {
      if (held.command_m_s == 0.0) continue;
      const double gain = held.speed_m_s / held.command_m_s;
      const double error = sure_errors * held.standard_error_m_s / std::abs(held.command_m_s);
      const bool is_still = std::abs(gain) < max_still && gain + error < min_moving;
      if (is_still || gain - error > min_moving) commands.push_back({std::abs(held.command_m_s), is_still});
    }
  }
  std::ranges::sort(commands, {}, &Held::size_m_s);
  return commands;
}

}  // namespace

bool CommandHole::holds(double command_m_s) const {
  return std::abs(command_m_s) >= from_m_s && std::abs(command_m_s) <= to_m_s;
}

std::optional<CommandHole> find_command_hole(const SteadyStateSpeeds& speeds) {
  const auto commands = sorted_commands(speeds);
  std::optional<CommandHole> best;
  for (std::size_t begin = 0; begin < commands.size();) {
    std::size_t end = begin;
    while (end < commands.size() && commands[end].is_still == commands[begin].is_still) ++end;
    const auto moving = [&](std::size_t from, std::size_t to) {
      return std::count_if(commands.begin() + static_cast<std::ptrdiff_t>(from),
                           commands.begin() + static_cast<std::ptrdiff_t>(to),
                           [](const Held& held) { return !held.is_still; });
    };
    const std::size_t count = end - begin;
    if (commands[begin].is_still && count >= min_commands && (!best || count > best->commands) &&
        moving(0, begin) >= static_cast<std::ptrdiff_t>(min_beside) &&
        moving(end, commands.size()) >= static_cast<std::ptrdiff_t>(min_beside)) {
      best = CommandHole{commands[begin].size_m_s, commands[end - 1].size_m_s, commands[begin - 1].size_m_s,
                         commands[end].size_m_s, count};
    }
    begin = end;
  }
  return best;
}

SteadyStateSpeeds without_hole(SteadyStateSpeeds speeds, const CommandHole& hole) {
  for (auto* wheel : {&speeds.left, &speeds.right})
    std::erase_if(*wheel, [&](const SteadyStateSpeed& held) { return hole.holds(held.command_m_s); });
  return speeds;
}

}  // namespace wheelwright
