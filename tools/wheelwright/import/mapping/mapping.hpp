// What the channels of a recording mean to a robot: which are the commands, the wheels, the reference, and in
// what units. What is absent was neither given nor found.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import {

// A channel of a stream. As text "posL" where the file has one table, "/cmd_vel:linear.x" elsewhere. The name
// of a channel may also be its number in the file, from 1. One that was read from a text has all of it in
// `channel`: names may hold colons ("/tf:map.base_link", "data(:,1)"), so that the recording decides.
struct ChannelName {
  std::string stream;
  std::string channel;

  std::string text() const { return stream.empty() ? channel : stream + ":" + channel; }
  friend bool operator==(const ChannelName&, const ChannelName&) = default;
};

ChannelName channel_name(std::string_view text);

// A frame is one period of the time mapping.
enum class TimeUnit : std::uint8_t { s, ms, us, ns, hms, iso, cs, day, frame, min, h };

struct TimeMapping {
  std::optional<ChannelName> column;  // absent: the time of recording, or rows that are `period_s` apart
  TimeUnit unit = TimeUnit::s;
  std::optional<double> period_s;
};

enum class CommandKind : std::uint8_t { wheels, twist, duty, throttle };

struct CommandMapping {
  CommandKind kind = CommandKind::wheels;
  ChannelName first{};                  // left, or linear, or throttle
  std::optional<ChannelName> second{};  // right, or angular, or steering; absent: one for both wheels
  std::string unit = "m/s";             // of wheel and linear speeds; see speed_units() in units.hpp
  std::string angular_unit = "rad/s";
  double neutral = 0.0;                    // the number at which the wheels rest, taken off every value
  double full_scale = 1.0;                 // duty: the number that stands for all of it, beyond `neutral`
  std::optional<double> full_scale_m_s{};  // duty: the speed that all of it leads to
  double steering_gain = 1.0;  // left = throttle - gain * steering, right = throttle + gain * steering
  std::array<std::optional<ChannelName>, 2> direction{};  // bits beside a duty without a sign, left and right
  double forward = 1.0;                                   // their value that is forward
  bool left_reversed = false;                             // a positive number drives the wheel backward
  bool right_reversed = false;

  std::optional<double>
      timeout_s{};  // without a command for longer the robot stops; absent: it holds the last

  bool by_radius = false;     // the two channels are a velocity and the radius of the turn
  bool by_curvature = false;  // the same, with one over the radius

  bool is_of_body() const { return kind == CommandKind::twist || kind == CommandKind::throttle; }
  bool is_duty() const { return kind == CommandKind::duty || kind == CommandKind::throttle; }
};

enum class WheelKind : std::uint8_t { counts, angle, distance, speed };

struct WheelMapping {
  WheelKind kind = WheelKind::counts;
  ChannelName left{};
  std::optional<ChannelName> right{};  // absent: one wheel
  std::optional<int> bits{};           // width of a counter that wraps
  std::string unit{};                  // of angles, distances, speeds
  std::optional<double> metres_per_count{};
  std::optional<double> metres_per_count_right{};  // where it is not that of the left wheel
  std::optional<double> counts_per_turn{};
  std::optional<double> wheel_radius_m{};
  std::string scale_from{};  // "commands" or "reference", by which it was found; empty: someone states it
  bool left_reversed = false;
  bool right_reversed = false;
  bool per_row = false;            // the channels hold the travel since the row before
  bool by_command_sign = false;    // the channels hold no direction: it is that of the command
  bool unwrap_by_command = false;  // a counter that may go more than half around goes as commanded
  bool unit_assumed = false;       // the file does not say the unit; the motion may tell another
  bool body_motion = false;    // the channels are forward and turning motion of the body, not left and right
  std::string angular_unit{};  // of the turning motion; empty: rad/s of speeds, else rad
};

enum class ReferenceClock : std::uint8_t { same, shifted };

struct ReferenceMapping {
  std::optional<ChannelName> x;
  std::optional<ChannelName> y;
  std::optional<ChannelName> theta;
  std::optional<ChannelName> roll;            // beside theta, where Euler angles fold it at a quarter turn
  std::optional<ChannelName> qx, qy, qz, qw;  // in place of theta
  std::string unit = "m";  // or of places that are no distances, see units.hpp: geographic_unit, pixel_unit
  std::optional<double> metres_per_pixel;
  bool scale_from_robot = false;  // metres_per_pixel was found by how far the robot goes
  std::string angle_unit = "rad";
  bool clockwise = false;                    // headings grow clockwise
  bool y_points_right = false;               // of x
  std::optional<double> heading_offset_deg;  // added to the headings; absent: found in the motion
  ReferenceClock clock = ReferenceClock::same;
  std::optional<double> shift_s;     // added to its stamps, where its clock is shifted
  std::optional<double> clock_rate;  // seconds of the robot in one of its clock, from its first stamp on
};

struct ScalarMapping {
  ChannelName column;
  std::string unit;
  std::optional<double> lsb_per_deg_s{};  // of a gyro in raw numbers, unit LSB
  bool unit_is_stated = true;             // else the motion may tell another
};

struct Mapping {
  TimeMapping time;
  std::optional<CommandMapping> command;
  std::optional<WheelMapping> wheels;
  std::optional<ReferenceMapping> reference;
  std::optional<ScalarMapping> gyro;     // rad/s or deg/s
  std::optional<ScalarMapping> battery;  // V or mV
  std::string robot;
  std::optional<double> wheel_base_m;
};

// One key of a mapping file: "time.unit" and "ms".
struct MappingEntry {
  std::string key;
  std::string value;
  std::string
      source{};  // where a person said it: "--set time.unit=ms", the mapping file; empty where it was found
};

// A mapping as keys and values, in the order of a mapping file.
std::vector<MappingEntry> mapping_entries(const Mapping& mapping);

// Keys and values as the text of a mapping file (YAML, `wheelwright_mapping: 1`), and the entry that stands
// in each line from the first on; nullptr where none does.
struct MappingText {
  std::string text;
  std::vector<const MappingEntry*> lines;
};
MappingText mapping_text(const std::vector<MappingEntry>& entries);

}  // namespace wheelwright::import
