// The rows of a drive log of the daemon as the frames that the brain saw.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/log/drive_log.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright::daemon {

class RecordedFrames {
 public:
  // Keeps a reference to the log. Throws ConfigError where it lacks a column that the daemon writes; so do
  // the functions below, for a value that no daemon writes.
  explicit RecordedFrames(const DriveLog& log);

  std::size_t size() const { return log_.samples.size(); }
  std::int64_t tick(std::size_t row) const;
  const std::string& activity(std::size_t row) const { return activity_.texts[row]; }
  const WheelPair& command(std::size_t row) const { return log_.samples[row].command_m_s; }

  // Of the model that was driven by; 1 where the log is from before models were adapted.
  std::uint16_t model_version(std::size_t row) const;

  // All but the command.
  SensorFrame frame(std::size_t row) const;
  // With the command that was given. Throws ConfigError for an activity that this version does not know.
  SensorFrame frame_with_command(std::size_t row) const;

  // The robot as it was armed, standing where the first row finds it.
  SensorFrame before_start() const;

 private:
  WheelTicks travel(std::size_t row) const;
  double number(std::size_t row, const ExtraColumn& column, double least, double most) const;
  std::int64_t whole(std::size_t row, const ExtraColumn& column, double least, double most) const;
  double amperes(std::size_t row, const ExtraColumn& column) const;
  StopReason stop_reason(std::size_t row) const;
  std::string place(std::size_t row) const;

  const DriveLog& log_;
  const ExtraColumn& tick_;
  const ExtraColumn& activity_;
  const ExtraColumn& repetition_;
  const ExtraColumn& stop_;
  const ExtraColumn& after_gap_;
  const ExtraColumn& wheel_drop_;
  const ExtraColumn& overcurrents_;
  const ExtraColumn& current_left_;
  const ExtraColumn& current_right_;
  const ExtraColumn& doubtful_sign_;
  const ExtraColumn& travel_left_;
  const ExtraColumn& travel_right_;
  const ExtraColumn* model_version_;
  const ExtraColumn* late_us_;
  std::array<const ExtraColumn*, 6> light_{};
};

}  // namespace wheelwright::daemon
