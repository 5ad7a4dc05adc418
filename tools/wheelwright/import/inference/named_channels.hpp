// The channels whose names mean something.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Words that one of two names has and the other has not: "mocap_x" is nearer to "mocap_y" than to "odom_y".
int words_apart(const std::string& one, const std::string& other);

struct Named {
  const Stream* stream;
  const Channel* channel;
  NameMeaning meaning;

  ChannelName name() const { return {stream->name, channel->name}; }
};

// Of a wheel: an omega that is faster than any robot in m/s.
bool is_turn_rate(const Named& named);

struct NamedPair {
  Named first;
  Named second;
};

class NamedChannels {
 public:
  // But for those that `mapping` uses already.
  NamedChannels(std::span<const Recording> recordings, const Mapping& mapping);

  const std::vector<Named>& list() const { return named_; }
  std::vector<Named> all(Quantity quantity, NamedSide side) const;
  // The first two of one stream, else of two streams whose names differ by the side; a line in `findings`
  // where there are others.
  static std::optional<NamedPair> pair(const std::vector<Named>& first, const std::vector<Named>& second,
                                       std::vector<std::string>& findings);
  std::optional<NamedPair> sides(Quantity quantity, std::vector<std::string>& findings) const;
  // A wheel alone, by its side or without one.
  std::optional<Named> single(Quantity quantity) const;
  // An x and a y.
  bool has_places() const;
  // Two columns that differ by 1 and 2 alone, by 0 and 1, or by A and B: "m1_counts" and "m2_counts"; a line
  // in `findings`.
  std::optional<NamedPair> numbered_pair(Quantity quantity, std::vector<std::string>& findings) const;
  // Of the stream of another, without a side; nullptr where there is none.
  const Named* beside(const Named& other, Quantity quantity) const;

 private:
  std::vector<Named> named_;
};

}  // namespace wheelwright::import
