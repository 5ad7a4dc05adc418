#include "tools/wheelwright/import/inference/turning_sense.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/run_repair.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"

namespace wheelwright::import {
namespace {

using std::numbers::pi;

constexpr double sense_window_s = 0.5;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// What the reference and the robot did between two poses.
struct Window {
  std::complex<double> moved;
  double heading = unknown;  // half-way, in the unit of the column taken for radians
  double turned = unknown;   // the same
  double turn_of_robot = 0.0;
  bool follows = false;  // the window before ended where this one begins
};

class Correlation {
 public:
  void add(double a, double b, double weight = 1.0) {
    products_ += weight * a * b;
    first_ += weight * a * a;
    second_ += weight * b * b;
  }
  double value() const {
    return first_ > 0.0 && second_ > 0.0 ? products_ / std::sqrt(first_ * second_) : 0.0;
  }

 private:
  double products_ = 0.0;
  double first_ = 0.0;
  double second_ = 0.0;
};

double wrapped(double angle, double turn) {
  return angle - turn * std::round(angle / turn);
}

// How far the right wheel is ahead of the left one at each of the rows, in any unit.
Column turn_of_wheels(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
                      const std::array<double, 2>& directions) {
  const WheelTravel travel = wheel_travel(columns, rows, mapping);
  Column turn(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    turn[i] = directions[1] * travel.values[1][i] - directions[0] * travel.values[0][i];
  return turn;
}

Column turn_of_commands(const DriveColumns& columns, std::span<const std::size_t> rows,
                        const Mapping& mapping) {
  Mapping body = mapping;
  if (!body.wheel_base_m) body.wheel_base_m = 1.0;
  const auto commands = wheel_commands(columns, rows, body);
  Column turn(rows.size(), 0.0);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double rate = commands[1][i - 1] - commands[0][i - 1];
    const double step = rate * (columns.t_s[rows[i]] - columns.t_s[rows[i - 1]]);
    turn[i] = turn[i - 1] + (std::isfinite(step) ? step : 0.0);
  }
  return turn;
}

Column turn_of_robot(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
                     const std::array<double, 2>& directions) {
  return has_turning_wheels(columns, mapping) ? turn_of_wheels(columns, rows, mapping, directions)
                                              : turn_of_commands(columns, rows, mapping);
}

class Windows {
 public:
  Windows(const DriveColumns& columns, double turn) : columns_(columns), turn_(turn) {}

  void add_run(std::span<const std::size_t> rows, const Column& turn_of_robot) {
    std::size_t from = rows.size();
    bool follows = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!is_placed(rows[i]) || !std::isfinite(turn_of_robot[i])) continue;
      if (from < rows.size()) {
        if (columns_.t_s[rows[i]] - columns_.t_s[rows[from]] < sense_window_s) continue;
        add(rows[from], rows[i], turn_of_robot[i] - turn_of_robot[from], follows);
        follows = true;
      }
      from = i;
    }
  }

  const std::vector<Window>& list() const { return list_; }

 private:
  std::complex<double> place(std::size_t row) const {
    return columns_.x.empty() ? 0.0 : std::complex<double>(columns_.x[row], columns_.y[row]);
  }
  bool is_placed(std::size_t row) const {
    return std::isfinite(std::abs(place(row))) &&
           (columns_.theta_rad.empty() || std::isfinite(columns_.theta_rad[row]));
  }
  void add(std::size_t start, std::size_t end, double turn_of_robot, bool follows) {
    Window window{place(end) - place(start), unknown, unknown, turn_of_robot, follows};
    if (!columns_.theta_rad.empty()) {
      window.turned = wrapped(columns_.theta_rad[end] - columns_.theta_rad[start], turn_);
      window.heading = columns_.theta_rad[start] + 0.5 * window.turned;
    }
    list_.push_back(window);
  }

  const DriveColumns& columns_;
  double turn_;
  std::vector<Window> list_;
};

// Of the headings, in `unit` radians each.
void add_headings(const std::vector<Window>& windows, double unit, TurningSense& sense) {
  constexpr double longest_turn_rad = 1.0;
  std::complex<double> with = 0.0;
  std::complex<double> against = 0.0;
  double squares = 0.0;
  Correlation turns;
  for (const Window& window : windows) {
    if (!(std::abs(unit * window.turned) <= longest_turn_rad)) continue;
    // Twice the angle: a robot that drives backward moves against its heading.
    const double twice = 2.0 * unit * window.heading;
    with += window.moved * window.moved * std::polar(1.0, -twice);
    against += window.moved * window.moved * std::polar(1.0, twice);
    squares += std::norm(window.moved);
    turns.add(window.turned, window.turn_of_robot);
  }
  sense.headings = turns.value();
  if (!(squares > 0.0)) return;
  sense.with = std::abs(with) / squares;
  sense.against = std::abs(against) / squares;
}

// Twice the angle between two ways is the same whether the robot drove forward or backward.
double sense_of_places(const std::vector<Window>& windows) {
  Correlation turns;
  for (std::size_t i = 1; i < windows.size(); ++i) {
    if (!windows[i].follows) continue;
    const auto ways = windows[i].moved * std::conj(windows[i - 1].moved);
    if (!(std::abs(ways) > 0.0)) continue;
    turns.add(0.5 * std::arg(ways * ways), 0.5 * (windows[i].turn_of_robot + windows[i - 1].turn_of_robot),
              std::abs(ways));
  }
  return turns.value();
}

TurningSense sense_in(const DriveColumns& columns, const Mapping& mapping,
                      const std::array<double, 2>& directions, double turn) {
  Windows windows(columns, turn);
  for (const auto& rows : repair_runs(columns, mapping).runs)
    windows.add_run(rows, turn_of_robot(columns, rows, mapping, directions));
  TurningSense sense;
  add_headings(windows.list(), 2.0 * pi / turn, sense);
  sense.places = sense_of_places(windows.list());
  return sense;
}

}  // namespace

bool has_turning_wheels(const DriveColumns& columns, const Mapping& mapping) {
  return mapping.wheels && mapping.wheels->right && mapping.wheels->kind != WheelKind::speed &&
         !columns.wheel[1].empty();
}

TurningSense turning_sense(const DriveColumns& columns, const Mapping& mapping,
                           const std::array<double, 2>& directions, bool unit_is_known) {
  const TurningSense as_read = sense_in(columns, mapping, directions, 2.0 * pi);
  if (unit_is_known || columns.theta_rad.empty()) return as_read;
  const TurningSense degrees = sense_in(columns, mapping, directions, 360.0);
  const auto best = [](const TurningSense& sense) {
    return std::abs(sense.headings) + std::max(sense.with, sense.against);
  };
  return best(degrees) > best(as_read) ? degrees : as_read;
}

double gyro_sense(const DriveColumns& columns, const Mapping& mapping,
                  const std::array<double, 2>& directions) {
  if (columns.gyro.empty() || !has_turning_wheels(columns, mapping)) return 0.0;
  Correlation rates;
  for (const auto& rows : repair_runs(columns, mapping).runs) {
    const Column turn = turn_of_wheels(columns, rows, mapping, directions);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double duration_s = columns.t_s[rows[i]] - columns.t_s[rows[i - 1]];
      const double rate = (turn[i] - turn[i - 1]) / duration_s;
      if (std::isfinite(rate) && std::isfinite(columns.gyro[rows[i]])) rates.add(columns.gyro[rows[i]], rate);
    }
  }
  return rates.value();
}

}  // namespace wheelwright::import
