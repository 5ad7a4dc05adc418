#include "daemon/replay/recorded_frames.hpp"

#include <cmath>
#include <string_view>

#include "config/load/text_format.hpp"
#include "config/load/yaml_reader.hpp"

namespace wheelwright::daemon {
namespace {

using config::ConfigError;

const ExtraColumn* column_or_none(const DriveLog& log, std::string_view name) {
  for (const ExtraColumn& column : log.extra_columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

const ExtraColumn& column_of(const DriveLog& log, std::string_view name) {
  if (const ExtraColumn* column = column_or_none(log, name)) return *column;
  throw ConfigError(log.name + ": has no column '" + std::string(name) +
                    "', which a drive log of the daemon has");
}

// What the columns of a daemon's log can hold.
constexpr double max_ticks = 1e9;  // half a year of them
constexpr double max_travel_ticks = 9e15;
constexpr double max_amperes = 1e3;
constexpr double largest_byte = 255.0;
constexpr double largest_word = 65535.0;

}  // namespace

RecordedFrames::RecordedFrames(const DriveLog& log)
    : log_(log),
      tick_(column_of(log, "tick")),
      activity_(column_of(log, "activity")),
      repetition_(column_of(log, "repetition")),
      stop_(column_of(log, "stop")),
      after_gap_(column_of(log, "after_gap")),
      wheel_drop_(column_of(log, "wheel_drop")),
      overcurrents_(column_of(log, "overcurrents")),
      current_left_(column_of(log, "current_left_a")),
      current_right_(column_of(log, "current_right_a")),
      doubtful_sign_(column_of(log, "doubtful_sign")),
      travel_left_(column_of(log, "travel_ticks_left")),
      travel_right_(column_of(log, "travel_ticks_right")),
      model_version_(column_or_none(log, "model_version")),
      late_us_(column_or_none(log, "late_us")) {
  const std::array names{"light_left",         "light_front_left",  "light_center_left",
                         "light_center_right", "light_front_right", "light_right"};
  for (std::size_t s = 0; s < names.size(); ++s) light_.at(s) = &column_of(log, names.at(s));
  for (const ExtraColumn* words : {&activity_, &stop_}) {
    if (words->texts.size() != size())
      throw ConfigError(log.name + ": '" + words->name + "' must hold words");
  }
  for (std::size_t row = 1; row < size(); ++row) {
    if (tick(row) <= tick(row - 1)) throw ConfigError(place(row) + "'tick' must rise from row to row");
  }
}

std::int64_t RecordedFrames::tick(std::size_t row) const {
  return whole(row, tick_, 0.0, max_ticks);
}

std::uint16_t RecordedFrames::model_version(std::size_t row) const {
  return model_version_ == nullptr
             ? std::uint16_t{1}
             : static_cast<std::uint16_t>(whole(row, *model_version_, 0.0, largest_word));
}

SensorFrame RecordedFrames::frame(std::size_t row) const {
  SensorFrame frame;
  frame.tick = tick(row) + 1;  // the run starts one tick after it was armed
  frame.stop = stop_reason(row);
  frame.armed = frame.stop == StopReason::none;
  const DriveSample& sample = log_.samples[row];
  frame.valid = sample.ticks.has_value();
  if (!frame.valid) return frame;
  frame.counted_ticks = *sample.ticks;
  frame.ticks = travel(row);
  if (late_us_ != nullptr) {
    frame.late_us = static_cast<std::int32_t>(whole(row, *late_us_, 0.0, largest_late_us));
  }
  frame.after_gap = after_gap_.values[row] > 0.0;
  frame.doubtful_sign = doubtful_sign_.values[row] > 0.0;
  frame.wheel_drop = wheel_drop_.values[row] > 0.0;
  frame.overcurrents = static_cast<std::uint8_t>(whole(row, overcurrents_, 0.0, largest_byte));
  frame.motor_current_a = {amperes(row, current_left_), amperes(row, current_right_)};
  frame.battery_v = sample.battery_v.value_or(0.0);
  for (std::size_t s = 0; s < light_.size(); ++s) {
    frame.light_bumper.at(s) = static_cast<std::uint16_t>(whole(row, *light_.at(s), 0.0, largest_word));
  }
  return frame;
}

SensorFrame RecordedFrames::frame_with_command(std::size_t row) const {
  SensorFrame result = frame(row);
  result.command.tick = result.tick;
  result.command.speed_m_s = command(row);
  result.command.repetition = static_cast<std::uint16_t>(whole(row, repetition_, 0.0, largest_word));
  for (int code = 0; code <= static_cast<int>(Activity::stopped); ++code) {
    result.command.activity = static_cast<Activity>(code);
    if (name_of(result.command.activity) == activity(row)) return result;
  }
  throw ConfigError(place(row) + "'" + activity(row) + "' is no activity that this version knows");
}

SensorFrame RecordedFrames::before_start() const {
  SensorFrame frame;
  frame.armed = true;
  for (std::size_t row = 0; row < size() && !frame.valid; ++row) {
    frame.valid = log_.samples[row].ticks.has_value();
    if (frame.valid) frame.ticks = travel(row);
  }
  return frame;
}

WheelTicks RecordedFrames::travel(std::size_t row) const {
  return {whole(row, travel_left_, -max_travel_ticks, max_travel_ticks),
          whole(row, travel_right_, -max_travel_ticks, max_travel_ticks)};
}

double RecordedFrames::number(std::size_t row, const ExtraColumn& column, double least, double most) const {
  const double value = column.values[row];
  if (value >= least && value <= most) return value;
  throw ConfigError(place(row) + "'" + column.name + "' must be a number from " +
                    config::plain_number(least) + " to " + config::plain_number(most));
}

std::int64_t RecordedFrames::whole(std::size_t row, const ExtraColumn& column, double least,
                                   double most) const {
  return std::llround(number(row, column, least, most));
}

// Of the milliamperes that the robot reports, by the same product as then.
double RecordedFrames::amperes(std::size_t row, const ExtraColumn& column) const {
  return 1e-3 * std::round(1e3 * number(row, column, -max_amperes, max_amperes));
}

StopReason RecordedFrames::stop_reason(std::size_t row) const {
  for (int code = 0; code <= static_cast<int>(last_stop_reason); ++code) {
    const auto reason = static_cast<StopReason>(code);
    if (name_of(reason) == stop_.texts[row]) return reason;
  }
  throw ConfigError(place(row) + "'" + stop_.texts[row] + "' is no reason to stop that this version knows");
}

std::string RecordedFrames::place(std::size_t row) const {
  return log_.name + ":" + std::to_string(log_.first_line + row) + ": ";
}

}  // namespace wheelwright::daemon
