// Texts as recordings, for tests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/formats/text/text_recording.hpp"

namespace wheelwright::test {

using Values = std::vector<double>;

inline import::Recording read_text(const std::string& text) {
  auto recording = import::read_text_table(text, "log.csv");
  INFO((recording ? std::string() : recording.error()));
  REQUIRE(recording);
  return *std::move(recording);
}

inline std::string refusal_of(const std::string& text) {
  const auto recording = import::read_text_table(text, "log.csv");
  REQUIRE_FALSE(recording);
  return recording.error();
}

inline const import::Stream& stream(const import::Recording& recording, const std::string& name = "") {
  const import::Stream* found = recording.find(name);
  INFO("stream '" << name << "'");
  REQUIRE(found != nullptr);
  return *found;
}

inline Values values(const import::Stream& stream, const std::string& channel) {
  const import::Channel* found = stream.find(channel);
  INFO("channel '" << channel << "'");
  REQUIRE(found != nullptr);
  CHECK(found->values.size() == stream.rows);
  return found->values;
}

// Of the only stream of a text.
inline Values values(const std::string& text, const std::string& channel) {
  const import::Recording recording = read_text(text);
  REQUIRE(recording.streams.size() == 1);
  return values(recording.streams.front(), channel);
}

inline std::vector<std::string> names(const import::Stream& stream) {
  std::vector<std::string> all;
  for (const import::Channel& channel : stream.channels) all.push_back(channel.name);
  return all;
}

inline std::string unit(const import::Recording& recording, const std::string& channel) {
  const import::Channel* found = recording.streams.front().find(channel);
  REQUIRE(found != nullptr);
  return found->unit;
}

inline bool has_remark(const import::Recording& recording, const std::string& part) {
  return std::ranges::any_of(
      recording.remarks, [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
}

}  // namespace wheelwright::test
