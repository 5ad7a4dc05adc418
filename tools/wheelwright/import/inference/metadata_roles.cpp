#include "tools/wheelwright/import/inference/metadata_roles.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

std::optional<double> number_between(const std::string& text, double minimum, double maximum) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= minimum) || value > maximum) {
    return std::nullopt;
  }
  return value;
}

// What a key of the metadata may be, and the smaller unit that a larger number may be in.
struct StatedNumber {
  std::string_view key;
  double minimum;
  double maximum;
  std::string_view unit;
  std::string_view smaller_unit;
};

constexpr StatedNumber wheel_base{"wheel_base_m", 0.001, 10.0, "m", "mm"};
constexpr StatedNumber period{"period_s", 0.0001, 10.0, "s", "ms"};
constexpr StatedNumber left_scale{"metres_per_tick_left", 1e-9, 1.0, "m", "mm"};
constexpr StatedNumber right_scale{"metres_per_tick_right", 1e-9, 1.0, "m", "mm"};

std::string range_text(const StatedNumber& stated) {
  return "from " + config::plain_number(stated.minimum) + " to " + config::plain_number(stated.maximum) +
         " " + std::string(stated.unit);
}

class Metadata {
 public:
  Metadata(const Recording& recording, std::vector<std::string>& doubts)
      : recording_(recording), doubts_(doubts) {}

  // Nothing where the file does not state it; a doubt as well where it states what cannot be.
  std::optional<double> number(const StatedNumber& stated) const {
    const auto entry = std::ranges::find(recording_.metadata, stated.key,
                                         [](const auto& pair) { return std::string_view(pair.first); });
    if (entry == recording_.metadata.end()) return std::nullopt;
    const auto value = number_between(entry->second, stated.minimum, stated.maximum);
    if (!value) doubt(stated, entry->second);
    return value;
  }

 private:
  void doubt(const StatedNumber& stated, const std::string& text) const {
    constexpr double smaller_per_unit = 1000.0;
    const bool is_smaller =
        number_between(text, stated.maximum, smaller_per_unit * stated.maximum).has_value();
    const std::string line = recording_.name + ": " + std::string(stated.key) + ": " + text + " is not " +
                             range_text(stated) +
                             (is_smaller ? "; is it in " + std::string(stated.smaller_unit) + "?" : "");
    if (std::ranges::find(doubts_, line) == doubts_.end()) doubts_.push_back(line);
  }

  const Recording& recording_;
  std::vector<std::string>& doubts_;
};

// "Length Units" of a motion capture system, of the places in the same file whose columns state none.
void map_length_unit(std::span<const Recording> recordings, const Recording& recording, Mapping& mapping) {
  if (!mapping.reference || !mapping.reference->x || mapping.reference->unit != "m") return;
  const FoundChannel x = find_channel(recordings, *mapping.reference->x);
  const bool is_here =
      std::ranges::any_of(recording.streams, [&](const Stream& stream) { return &stream == x.stream; });
  if (!is_here) return;
  for (const auto& [key, text] : recording.metadata) {
    const NameWords words(key);
    const bool is_unit =
        words.has_any({"unit", "units"}) && words.has_any({"length", "distance", "position"});
    const auto unit = is_unit ? find_unit(distance_units(), text) : std::nullopt;
    if (unit) mapping.reference->unit = unit->name;
  }
}

// Of frames or samples, and not of a filter or a motor.
bool names_a_rate(const std::string& name) {
  const NameWords words(name);
  if (words.has_any({"cutoff", "pwm", "filter", "baud", "capture", "control"})) return false;
  const bool of_rows = words.has_any({"frame", "frames", "sample", "sampling", "log", "logging", "hz"});
  return words.has_any({"fps", "framerate", "samplerate"}) ||
         (words.has_any({"rate", "frequency", "freq"}) && of_rows);
}

constexpr double fastest_hz = 10'000.0;
constexpr double slowest_hz = 0.1;

// "fps: 30", "Frame Rate (Hz): 30", "sample_rate = 50 Hz", or a column "fps" of one number.
std::optional<double> stated_rate_hz(const Recording& recording) {
  for (const auto& [key, text] : recording.metadata) {
    if (!names_a_rate(key)) continue;
    const std::string number = text.substr(0, text.find_first_not_of("0123456789."));
    if (const auto rate = number_between(number, slowest_hz, fastest_hz)) return rate;
  }
  for (const Stream& stream : recording.streams) {
    for (const Channel& channel : stream.channels) {
      const ValueRange range = range_of(channel.values);
      if (names_a_rate(channel.name) && range.size() == 0.0 && range.least >= slowest_hz &&
          range.most <= fastest_hz)
        return range.least;
    }
  }
  return std::nullopt;
}

// A clock of the rows says more than a rate.
bool takes_rate(std::span<const Recording> recordings, const Recording& recording, const Mapping& mapping) {
  const bool is_stamped =
      std::ranges::any_of(recording.streams, [](const Stream& stream) { return !stream.received_s.empty(); });
  if (is_stamped) return false;
  if (!mapping.time.column) return true;
  const FoundChannel time = find_channel(recordings, *mapping.time.column);
  return time.channel != nullptr && counts_frames(*time.channel);
}

}  // namespace

void stamp_frames(Recording& recording) {
  const auto rate_hz = stated_rate_hz(recording);
  if (!rate_hz) return;
  for (Stream& stream : recording.streams) {
    if (!stream.received_s.empty() || time_channel(stream, {}) != nullptr) continue;
    const auto frames = std::ranges::find_if(stream.channels, counts_frames);
    Channel time{"time (by the rate of the file)", "s", {}};
    for (std::size_t row = 0; row < stream.rows; ++row)
      time.values.push_back(
          (frames == stream.channels.end() ? static_cast<double>(row) : frames->values[row]) / *rate_hz);
    stream.channels.push_back(std::move(time));
  }
}

void map_metadata(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& doubts) {
  for (const auto& recording : recordings) {
    const Metadata metadata(recording, doubts);
    for (const auto& [key, text] : recording.metadata)
      if (key == "robot" && mapping.robot.empty()) mapping.robot = text;
    if (!mapping.wheel_base_m) mapping.wheel_base_m = metadata.number(wheel_base);
    if (!mapping.time.period_s) mapping.time.period_s = metadata.number(period);
    if (!mapping.time.period_s && takes_rate(recordings, recording, mapping)) {
      if (const auto rate_hz = stated_rate_hz(recording)) mapping.time.period_s = 1.0 / *rate_hz;
    }
    map_length_unit(recordings, recording, mapping);
    if (!mapping.wheels) continue;
    if (!mapping.wheels->metres_per_count) mapping.wheels->metres_per_count = metadata.number(left_scale);
    const auto right = metadata.number(right_scale);
    if (right && right != mapping.wheels->metres_per_count) mapping.wheels->metres_per_count_right = right;
  }
}

}  // namespace wheelwright::import
