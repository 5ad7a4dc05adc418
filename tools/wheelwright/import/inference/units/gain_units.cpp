#include "tools/wheelwright/import/inference/units/gain_units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include "tools/wheelwright/import/columns/column_shapes.hpp"

namespace wheelwright::import {
bool is_near(double gain, double unit) {
  return gain > 0.0 && std::abs(std::log(gain / unit)) < std::log(near_gain);
}

double rounded_gain(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 5).ptr;
  double rounded = value;
  std::from_chars(text.data(), end, rounded);
  return rounded;
}

double full_scale_of(double largest_duty) {
  for (const double scale : {1.0, 100.0, 255.0, 1000.0, 1023.0, 4095.0, 32767.0, 65535.0}) {
    if (largest_duty <= scale) return scale;
  }
  return largest_duty;
}

double full_scale_about(double neutral, double largest_beyond) {
  constexpr double pulse_us = 500.0;
  const double usual = neutral > 2.0 * pulse_us && largest_beyond <= pulse_us ? pulse_us : std::abs(neutral);
  return std::max(usual, largest_beyond);
}

void set_full_scale(const DriveColumns& columns, const GivenMapping& given, CommandMapping& command) {
  if (!command.is_duty() || given.says("command.full_scale")) return;
  const double largest_duty = std::max(largest(columns.command[0]), largest(columns.command[1]));
  command.full_scale =
      command.neutral == 0.0 ? full_scale_of(largest_duty) : full_scale_about(command.neutral, largest_duty);
}

}  // namespace wheelwright::import
