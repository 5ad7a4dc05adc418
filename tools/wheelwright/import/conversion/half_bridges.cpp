#include "tools/wheelwright/import/conversion/half_bridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "config/load/ascii_text.hpp"

namespace wheelwright::import {
namespace {

std::string letters_of(const std::string& name) {
  std::string letters;
  for (const char c : config::lower_case(name))
    if (config::is_digit(c) || (c >= 'a' && c <= 'z')) letters += c;
  return letters;
}

Channel* channel_called(Stream& stream, std::string_view name) {
  const auto found = std::ranges::find_if(
      stream.channels, [&](const Channel& channel) { return letters_of(channel.name) == name; });
  return found == stream.channels.end() ? nullptr : &*found;
}

// Of two inputs one rests at each row.
bool take_turns(const Channel& forward, const Channel& backward) {
  for (std::size_t row = 0; row < forward.values.size(); ++row)
    if (forward.values[row] > 0.0 && backward.values[row] > 0.0) return false;
  return true;
}

bool are_bits(const Channel& channel) {
  return std::ranges::all_of(channel.values, [](double value) { return !(value > 0.0) || value == 1.0; });
}

struct HalfBridge {
  Channel* forward;
  Channel* backward;
  Channel* size;
};

bool has_size(const HalfBridge& bridge) {
  return bridge.size != nullptr && are_bits(*bridge.forward) && are_bits(*bridge.backward);
}

// The names of the channels that are in the first one from then on.
std::vector<std::string> join(const HalfBridge& bridge, const std::string& name) {
  const Channel* size = has_size(bridge) ? bridge.size : nullptr;
  for (std::size_t row = 0; row < bridge.forward->values.size(); ++row) {
    const double sign = bridge.forward->values[row] - bridge.backward->values[row];
    bridge.forward->values[row] = size != nullptr ? sign * size->values[row] : sign;
  }
  bridge.forward->name = name;
  std::vector<std::string> joined{bridge.backward->name};
  if (size != nullptr) joined.push_back(size->name);
  return joined;
}

}  // namespace

bool join_half_bridges(Stream& stream) {
  const std::array<HalfBridge, 2> bridges{
      HalfBridge{channel_called(stream, "in1"), channel_called(stream, "in2"), channel_called(stream, "ena")},
      HalfBridge{channel_called(stream, "in3"), channel_called(stream, "in4"),
                 channel_called(stream, "enb")}};
  const bool are_there = std::ranges::all_of(bridges, [](const HalfBridge& bridge) {
    return bridge.forward != nullptr && bridge.backward != nullptr &&
           take_turns(*bridge.forward, *bridge.backward);
  });
  if (!are_there) return false;
  std::vector<std::string> joined;
  for (std::size_t motor = 0; motor < bridges.size(); ++motor) {
    const auto names = join(bridges[motor], "pwm_" + std::to_string(motor + 1));
    joined.insert(joined.end(), names.begin(), names.end());
  }
  std::erase_if(stream.channels, [&](const Channel& channel) {
    return std::ranges::find(joined, channel.name) != joined.end();
  });
  return true;
}

}  // namespace wheelwright::import
