// A drive of a differential robot, as numbers that a test writes in whatever form a foreign log has.
//
// The robot: each wheel's speed comes nearer to its command by a fifth in each period, after two periods of
// nothing. Nothing of the library is in it.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace wheelwright::test {

struct ForeignRow {
  double t_s;
  double command_left, command_right;  // m/s
  std::int64_t counts_left, counts_right;
  double x, y, theta;

  double linear() const { return 0.5 * (command_left + command_right); }
  double angular(double base_m) const { return (command_right - command_left) / base_m; }
};

struct ForeignDrive {
  static constexpr double base_m = 0.3;
  static constexpr double metres_per_count = 0.0005;
  double period_s = 0.05;
  std::vector<ForeignRow> rows;
};

// Of the commands of a row in m/s.
using CommandOfRow = std::function<double(std::size_t)>;
inline ForeignDrive drive_by(const CommandOfRow& left_command, const CommandOfRow& right_command,
                             std::size_t row_count = 1200, double period_s = 0.05,
                             double metres_per_count = ForeignDrive::metres_per_count) {
  ForeignDrive drive{period_s, {}};
  std::vector<double> left, right;
  double speed_left = 0.0, speed_right = 0.0, way_left = 0.0, way_right = 0.0, x = 0.0, y = 0.0, theta = 0.0;
  for (std::size_t k = 0; k < row_count; ++k) {
    left.push_back(left_command(k));
    right.push_back(right_command(k));
    drive.rows.push_back({period_s * static_cast<double>(k), left[k], right[k],
                          static_cast<std::int64_t>(std::floor(way_left / metres_per_count)),
                          static_cast<std::int64_t>(std::floor(way_right / metres_per_count)), x, y, theta});
    speed_left += 0.2 * ((k >= 2 ? left[k - 2] : 0.0) - speed_left);
    speed_right += 0.2 * ((k >= 2 ? right[k - 2] : 0.0) - speed_right);
    way_left += period_s * speed_left;
    way_right += period_s * speed_right;
    const double turn = period_s * (speed_right - speed_left) / ForeignDrive::base_m;
    const double forward = 0.5 * period_s * (speed_left + speed_right);
    x += forward * std::cos(theta + 0.5 * turn);
    y += forward * std::sin(theta + 0.5 * turn);
    theta += turn;
  }
  return drive;
}

// Commands that are held for 37 rows each.
inline ForeignDrive foreign_drive(std::size_t row_count = 1200, double period_s = 0.05,
                                  double metres_per_count = ForeignDrive::metres_per_count) {
  constexpr double left_commands[] = {0.0, 0.2, 0.1, -0.15, 0.25, 0.05, 0.18, -0.1, 0.22, 0.12};
  constexpr double right_commands[] = {0.0, 0.2, 0.25, -0.1, 0.12, 0.2, 0.18, 0.15, 0.08, -0.12};
  return drive_by(
      [&](std::size_t k) { return left_commands[k / 37 % 10] + 0.01 * static_cast<double>(k / 370 % 3); },
      [&](std::size_t k) { return right_commands[k / 37 % 10]; }, row_count, period_s, metres_per_count);
}

// Commands that change at every row, as a joystick's do.
inline ForeignDrive joystick_drive() {
  const auto wave = [](std::size_t k, double period_rows) {
    return std::sin(6.283185307 * static_cast<double>(k) / period_rows);
  };
  return drive_by([&](std::size_t k) { return 0.12 + 0.08 * wave(k, 61.0) + 0.05 * wave(k, 23.7); },
                  [&](std::size_t k) { return 0.11 - 0.06 * wave(k, 47.0) + 0.06 * wave(k, 131.0); });
}

// A text with a line of `fields` for each row.
inline std::string foreign_text(const ForeignDrive& drive, const std::string& header,
                                const std::function<std::string(const ForeignRow&)>& fields) {
  std::string text = header.empty() ? "" : header + "\n";
  for (const auto& row : drive.rows) text += fields(row) + "\n";
  return text;
}

}  // namespace wheelwright::test
