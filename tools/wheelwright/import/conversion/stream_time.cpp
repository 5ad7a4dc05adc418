#include "tools/wheelwright/import/conversion/stream_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/time_units.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr double max_between_stamps_s = 1.0;

bool agree(const std::vector<double>& stamps, const std::vector<double>& received_s) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (std::isfinite(stamps[i])) differences.push_back(std::abs(received_s[i] - stamps[i]));
  }
  if (differences.size() < stamps.size()) return false;
  return !differences.empty() && median(std::move(differences)) < max_between_stamps_s;
}

// A time of day goes on past midnight.
void unwrap_midnight(std::vector<double>& t_s) {
  constexpr double day_s = 86400.0;
  double days = 0.0;
  double last = nothing;
  for (double& t : t_s) {
    if (std::isfinite(last) && t < last - day_s / 2) days += day_s;
    if (std::isfinite(t)) last = t;
    t += days;
  }
}

std::vector<double> in_seconds(std::vector<double> values, TimeUnit unit) {
  if (unit != TimeUnit::hms && unit != TimeUnit::iso) unwrap_clock(values);
  for (double& t : values) t *= seconds_in(unit);
  if (unit == TimeUnit::hms) unwrap_midnight(values);
  return values;
}

std::vector<double> frames_in_seconds(std::vector<double> frames, std::optional<double> period_s) {
  if (!period_s) return {};
  for (double& frame : frames) frame *= *period_s;
  return frames;
}

// That of the mapping; of a column of the same name in another file, which may be in another unit, its own.
TimeUnit unit_here(const Stream& stream, const Channel& channel, const TimeMapping& time) {
  const bool is_text = time.unit == TimeUnit::hms || time.unit == TimeUnit::iso;
  return is_text || is_plausible_unit(channel.values, time.unit)
             ? time.unit
             : time_unit_of(stream, channel, time.period_s);
}

bool goes_by_one(const std::vector<double>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] != values[i - 1] + 1.0) return false;
  return values.size() > 1;
}

const Channel* own_time(const Stream& stream) {
  if (is_tum(stream)) return &stream.channels.front();
  for (const auto& channel : stream.channels) {
    if (meaning_of(stream, channel).quantity == Quantity::time) return &channel;
  }
  return nullptr;
}

}  // namespace

const Channel* channel_of(const Stream& stream, const std::string& name) {
  if (const Channel* channel = stream.find(name)) return channel;
  const bool is_number =
      !name.empty() && name.size() < 6 && name.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = is_number ? std::stoul(name) : 0;
  return number >= 1 && number <= stream.channels.size() ? &stream.channels[number - 1] : nullptr;
}

const Channel* channel_of(const Stream& stream, const ChannelName& name) {
  if (!name.stream.empty()) return name.stream == stream.name ? channel_of(stream, name.channel) : nullptr;
  if (const Channel* channel = channel_of(stream, name.channel)) return channel;
  const bool is_long = name.channel.size() > stream.name.size() + 1 && !stream.name.empty();
  if (!is_long || !name.channel.starts_with(stream.name + ":")) return nullptr;
  return channel_of(stream, name.channel.substr(stream.name.size() + 1));
}

const Channel* stamps_of_sender(const Stream& stream) {
  const Channel* stamps = stream.find("header.stamp");
  return stamps != nullptr ? stamps : stream.find("stamp");
}

bool is_tum(const Stream& stream) {
  if (stream.channels.size() != 8 || stream.channels.front().name != "1") return false;
  std::size_t unit_quaternions = 0;
  const std::size_t rows = stream.channels.front().values.size();
  for (std::size_t i = 0; i < rows; ++i) {
    double squares = 0.0;
    for (std::size_t k = 4; k < 8; ++k)
      squares += stream.channels[k].values[i] * stream.channels[k].values[i];
    if (std::abs(squares - 1.0) < 0.02) ++unit_quaternions;
  }
  return rows > 1 && unit_quaternions * 10 > rows * 9;
}

std::optional<TimeUnit> time_unit_stated_for(const Stream& stream, const Channel& channel) {
  if (!channel.unit.empty()) return stated_time_unit(channel.unit);
  const NameWords words(channel.name);
  if (words.empty()) return std::nullopt;
  if (const auto unit = stated_time_unit(meaning_of(stream, channel).unit)) return unit;
  // "t", "s" and "h" are names; "time_sec", "ms" hold a unit.
  return words.last().size() > 1 ? stated_time_unit(words.last()) : std::nullopt;
}

bool counts_frames(const Channel& channel) {
  const NameWords words(channel.name);
  const bool names_frames =
      !words.empty() &&
      std::ranges::all_of(
          words.words(),
          [](const std::string& word) {
            return NameWords(word).has_any(
                {"frame",     "frames",     "sample", "samples", "image", "video", "no",      "number",
                 "nr",        "num",        "id",     "idx",     "index", "count", "counter", "iter",
                 "iteration", "iterations", "loop",   "step",    "cycle", "i",     "n",       "k"});
          }) &&
      (words.has_any({"frame", "frames", "sample", "samples"}) ||
       (words.has_any({"iter", "iteration", "iterations", "loop", "step", "cycle", "i", "n", "k"}) &&
        goes_by_one(channel.values)));
  return names_frames && are_whole(channel.values) && std::ranges::is_sorted(channel.values) &&
         channel.values.size() > 1 && channel.values.front() < channel.values.back();
}

TimeUnit time_unit_of(const Stream& stream, const Channel& channel, std::optional<double> period_s) {
  if (counts_frames(channel)) return TimeUnit::frame;
  if (channel.unit == "hms") return TimeUnit::hms;
  if (channel.unit == "iso") return TimeUnit::iso;
  const TimeUnit by_numbers = time_unit(channel.values, period_s);
  const auto stated = time_unit_stated_for(stream, channel);
  // A header may be wrong, and is where its unit gives no rate at which anybody logs.
  return stated && is_plausible_unit(channel.values, *stated) ? *stated : by_numbers;
}

const Channel* time_channel(const Stream& stream, const TimeMapping& time) {
  if (time.column) {
    if (const Channel* channel = channel_of(stream, *time.column)) return channel;
  }
  return stream.received_s.empty() ? own_time(stream) : nullptr;
}

std::vector<double> stream_times(const Stream& stream, const TimeMapping& time) {
  if (time.column) {
    if (const Channel* channel = channel_of(stream, *time.column)) {
      if (time.unit != TimeUnit::frame) return in_seconds(channel->values, unit_here(stream, *channel, time));
      return frames_in_seconds(channel->values, time.period_s);
    }
  }
  if (!stream.received_s.empty()) {
    const Channel* stamps = stamps_of_sender(stream);
    return stamps != nullptr && agree(stamps->values, stream.received_s) ? stamps->values : stream.received_s;
  }
  if (const Channel* channel = own_time(stream)) {
    return in_seconds(channel->values, time_unit_of(stream, *channel, time.period_s));
  }
  if (!time.period_s) return {};
  const auto frames = std::ranges::find_if(stream.channels, counts_frames);
  if (frames != stream.channels.end()) return frames_in_seconds(frames->values, time.period_s);
  std::vector<double> t_s(stream.rows);
  for (std::size_t i = 0; i < t_s.size(); ++i) t_s[i] = *time.period_s * static_cast<double>(i);
  return t_s;
}

}  // namespace wheelwright::import
