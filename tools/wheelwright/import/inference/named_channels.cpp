#include "tools/wheelwright/import/inference/named_channels.hpp"

#include <algorithm>

namespace wheelwright::import {

NamedChannels::NamedChannels(std::span<const Recording> recordings) {
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      for (const auto& channel : stream.channels) {
        const NameMeaning meaning = meaning_of(stream, channel);
        if (meaning.quantity != Quantity::unknown) named_.push_back({&stream, &channel, meaning});
      }
    }
  }
}

std::vector<Named> NamedChannels::all(Quantity quantity, NamedSide side) const {
  std::vector<Named> result;
  for (const auto& named : named_) {
    if (named.meaning.quantity == quantity && named.meaning.side == side) result.push_back(named);
  }
  return result;
}

std::optional<NamedPair> NamedChannels::pair(const std::vector<Named>& first,
                                             const std::vector<Named>& second,
                                             std::vector<std::string>& findings) {
  std::optional<NamedPair> found;
  std::string others;
  for (const auto& a : first) {
    const auto b = std::ranges::find(second, a.stream, &Named::stream);
    if (b == second.end()) continue;
    if (!found) {
      found = NamedPair{a, *b};
    } else if (a.stream != found->first.stream) {
      others += (others.empty() ? "" : ", ") + a.name().text();
    }
  }
  if (found && !others.empty()) {
    findings.push_back(found->first.name().text() + " was taken; there are also " + others);
  }
  return found;
}

std::optional<NamedPair> NamedChannels::sides(Quantity quantity, std::vector<std::string>& findings) const {
  return pair(all(quantity, NamedSide::left), all(quantity, NamedSide::right), findings);
}

std::optional<Named> NamedChannels::single(Quantity quantity) const {
  for (const NamedSide side : {NamedSide::none, NamedSide::left, NamedSide::right}) {
    const auto found = all(quantity, side);
    if (!found.empty()) return found.front();
  }
  return std::nullopt;
}

std::optional<NamedPair> NamedChannels::numbered_pair(Quantity quantity,
                                                      std::vector<std::string>& findings) const {
  const auto candidates = all(quantity, NamedSide::none);
  for (const auto& first : candidates) {
    for (const auto& second : candidates) {
      std::string expected = first.channel->name;
      const auto digit = expected.find('1');
      if (digit == std::string::npos) continue;
      expected[digit] = '2';
      if (second.stream != first.stream || second.channel->name != expected) continue;
      findings.push_back(first.channel->name + " is taken for the left wheel and " + expected +
                         " for the right one; nothing says so");
      return NamedPair{first, second};
    }
  }
  return std::nullopt;
}

const Named* NamedChannels::beside(const Named& other, Quantity quantity) const {
  for (const auto& named : named_) {
    if (named.stream == other.stream && named.meaning.quantity == quantity &&
        named.meaning.side == NamedSide::none)
      return &named;
  }
  return nullptr;
}

}  // namespace wheelwright::import
