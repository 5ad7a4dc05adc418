#include "tools/wheelwright/import/inference/named_channels.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"

namespace wheelwright::import {

namespace {

// "m2" of "m1", "data[1]" of "data[0]"; empty where there is no such number.
std::string next_number(const std::string& name) {
  std::string next = name;
  for (const auto& [number, other] : {std::pair{'1', '2'}, {'0', '1'}}) {
    const auto digit = next.find(number);
    if (digit == std::string::npos) continue;
    next[digit] = other;
    return next;
  }
  return {};
}

// "encB" of "encA", "pwm_b" of "pwm_a": motors that are called by letters; empty where the name has no such
// word.
std::string next_letter(const std::string& name) {
  const auto count = [](const std::string& of, std::string_view word) {
    const NameWords words(of);
    return std::ranges::count(words.words(), word);
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] != 'a' && name[i] != 'A') continue;
    std::string next = name;
    ++next[i];
    if (count(name, "a") == 1 && count(next, "a") == 0 && count(next, "b") == 1) return next;
  }
  return {};
}

// A speed along the x of the floor, beside one along y: a robot on two wheels does not slide sideways.
bool is_of_the_floor(const Stream& stream, const Channel& channel) {
  constexpr double sliding = 0.2;
  std::string other = channel.name;
  const auto at = other.find_last_of("xX");
  if (at == std::string::npos) return false;
  ++other[at];
  const Channel* sideways = stream.find(other);
  return sideways != nullptr && range_of(sideways->values).size() > sliding * range_of(channel.values).size();
}

// The two signals of one encoder, as levels.
bool are_levels(const Channel& channel) {
  return std::ranges::all_of(
      channel.values, [](double value) { return !(value != 0.0) || value == 1.0 || !std::isfinite(value); });
}

// One of each list from two streams of one type, whose names differ by the side alone.
std::optional<NamedPair> pair_of_topics(const std::vector<Named>& first, const std::vector<Named>& second) {
  constexpr int by_the_side = 2;
  for (const auto& a : first) {
    const auto b = std::ranges::find_if(second, [&a](const Named& other) {
      return other.stream != a.stream && other.stream->type == a.stream->type &&
             words_apart(a.name().text(), other.name().text()) <= by_the_side;
    });
    if (b != second.end()) return NamedPair{a, *b};
  }
  return std::nullopt;
}

}  // namespace

int words_apart(const std::string& one, const std::string& other) {
  const NameWords first(one);
  const NameWords second(other);
  const auto strange = [](const NameWords& name, const NameWords& in) {
    return static_cast<int>(
        std::ranges::count_if(name.words(), [&in](const std::string& word) { return !in.has(word); }));
  };
  return strange(first, second) + strange(second, first);
}

bool is_turn_rate(const Named& named) {
  return NameWords(named.channel->name).has_any({"omega", "w"}) &&
         largest(named.channel->values) > fastest_m_s;
}

NamedChannels::NamedChannels(std::span<const Recording> recordings, const Mapping& mapping) {
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      for (const auto& channel : stream.channels) {
        // A number alone is the place of a column, and the first may be the time.
        if (is_used(mapping, stream, channel) || std::ranges::all_of(channel.name, config::is_digit))
          continue;
        const NameMeaning meaning = meaning_of(stream, channel);
        if (meaning.quantity == Quantity::linear_speed && is_of_the_floor(stream, channel)) continue;
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
  if (!found) found = pair_of_topics(first, second);
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

bool NamedChannels::has_places() const {
  return !all(Quantity::x, NamedSide::none).empty() && !all(Quantity::y, NamedSide::none).empty();
}

std::optional<NamedPair> NamedChannels::numbered_pair(Quantity quantity,
                                                      std::vector<std::string>& findings) const {
  const auto candidates = all(quantity, NamedSide::none);
  for (const auto& first : candidates) {
    for (const auto& second : candidates) {
      const std::string& name = second.channel->name;
      if (second.stream != first.stream || name.empty()) continue;
      const bool is_next = name == next_number(first.channel->name) ||
                           (name == next_letter(first.channel->name) && !are_levels(*first.channel));
      if (!is_next) continue;
      findings.push_back(first.channel->name + " is taken for the left wheel and " + name +
                         " for the right one; nothing says so");
      return NamedPair{first, second};
    }
  }
  return std::nullopt;
}

const Named* NamedChannels::beside(const Named& other, Quantity quantity) const {
  const Named* best = nullptr;
  int least = 0;
  for (const auto& named : named_) {
    if (named.stream != other.stream || named.meaning.quantity != quantity ||
        named.meaning.side != NamedSide::none)
      continue;
    const int strange = words_apart(named.channel->name, other.channel->name);
    if (best != nullptr && strange >= least) continue;
    best = &named;
    least = strange;
  }
  return best;
}

}  // namespace wheelwright::import
