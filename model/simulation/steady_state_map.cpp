#include "model/simulation/steady_state_map.hpp"

#include <algorithm>
#include <cmath>

#include "model/simulation/model_simulation.hpp"

namespace wheelwright {
namespace {

constexpr int steps_each_way = 100;
constexpr double largest_command_m_s = 0.5;  // of the Open Interface
constexpr double settling_s = 2.0;
constexpr double averaged_s = 1.0;     // of the settled motion: a ripple is not the curve
constexpr double driving_m_s = 0.2;    // at which the dead band in turning is measured
constexpr double driving_share = 0.6;  // at most, of the fastest speed: both wheels can then turn the robot
constexpr int turn_steps = 25;
constexpr double curve_rad_s = 0.4;         // in which straightening is measured
constexpr double other_heading_rad = 0.03;  // from here on a stop and a straight way do not end a turn alike
constexpr double straightening_left = 0.1;  // of the turn
constexpr int longest_straightening_periods = 80;
constexpr double largest_turn_band_rad_s = 0.25;  // looked for

struct SteadyState {
  WheelPair floor_m_s;
  double turn_rad_s = 0.0;
};

SteadyState settled_at(ModelSimulation simulation, const WheelPair& command, double period_s) {
  const auto periods = [period_s](double time_s) { return static_cast<int>(std::lround(time_s / period_s)); };
  for (int k = 0; k < periods(settling_s); ++k) simulation.step(command);
  SteadyState sum;
  const int count = std::max(1, periods(averaged_s));
  for (int k = 0; k < count; ++k) {
    const ModelSimulation::Motion& motion = simulation.step(command);
    sum.floor_m_s.left += motion.floor_m_s.left;
    sum.floor_m_s.right += motion.floor_m_s.right;
    sum.turn_rad_s += motion.twist.w_rad_s;
  }
  return {{sum.floor_m_s.left / count, sum.floor_m_s.right / count}, sum.turn_rad_s / count};
}

}  // namespace

SteadyStateMap::SteadyStateMap(const LinearModel& linear_part, std::span<const EffectSetting> effects) {
  const ModelSimulation at_rest(linear_part, effects);
  for (int i = -steps_each_way; i <= steps_each_way; ++i) {
    const double command = largest_command_m_s * i / steps_each_way;
    const WheelPair speed = settled_at(at_rest, {command, command}, linear_part.period_s).floor_m_s;
    left_.push_back({command, left_.empty() ? speed.left : std::max(speed.left, left_.back().speed)});
    right_.push_back({command, right_.empty() ? speed.right : std::max(speed.right, right_.back().speed)});
  }
  limits_.fastest_wheel_m_s =
      std::min({left_.back().speed, right_.back().speed, -left_.front().speed, -right_.front().speed});
  limits_.turn_dead_band_rad_s = turn_dead_band_rad_s(at_rest, linear_part);
  limits_.straightening_periods = straightening_periods(at_rest, linear_part);
}

double SteadyStateMap::turn_dead_band_rad_s(const ModelSimulation& at_rest,
                                            const LinearModel& linear_part) const {
  const double speed_m_s = std::min(driving_m_s, driving_share * limits_.fastest_wheel_m_s);
  const auto turned_rad_s = [&](double w_rad_s) {
    const WheelPair asked = wheels_of_twist({speed_m_s, w_rad_s}, linear_part.wheel_base_m);
    return settled_at(at_rest, command_for(asked), linear_part.period_s).turn_rad_s;
  };
  const double straight_rad_s = turned_rad_s(0.0);
  double band_rad_s = 0.0;
  for (int i = 1; i <= turn_steps; ++i) {
    const double w_rad_s = largest_turn_band_rad_s * i / turn_steps;
    if (turned_rad_s(w_rad_s) - straight_rad_s > 0.5 * w_rad_s &&
        straight_rad_s - turned_rad_s(-w_rad_s) > 0.5 * w_rad_s)
      break;
    band_rad_s = w_rad_s;
  }
  return band_rad_s;
}

int SteadyStateMap::straightening_periods(ModelSimulation simulation, const LinearModel& linear_part) const {
  const double speed_m_s = std::min(driving_m_s, driving_share * limits_.fastest_wheel_m_s);
  const WheelPair curve = command_for(wheels_of_twist({speed_m_s, curve_rad_s}, linear_part.wheel_base_m));
  const WheelPair straight = command_for({speed_m_s, speed_m_s});
  for (double t_s = 0.0; t_s < settling_s; t_s += linear_part.period_s) simulation.step(curve);
  const double start_rad = simulation.pose().theta_rad;
  ModelSimulation stopping = simulation;
  std::vector<double> turned_rad;
  for (int k = 0; k < longest_straightening_periods; ++k) {
    stopping.step({});
    simulation.step(straight);
    turned_rad.push_back(simulation.pose().theta_rad - start_rad);
  }
  // What it turns on a straight way for ever, no command is to blame for.
  const double drift_rad = simulation.motion().twist.w_rad_s * linear_part.period_s;
  const auto left_rad = [&](std::size_t k) {
    return std::abs(turned_rad.back() - turned_rad[k] -
                    drift_rad * static_cast<double>(turned_rad.size() - 1 - k));
  };
  if (std::abs(simulation.pose().theta_rad - stopping.pose().theta_rad -
               drift_rad * longest_straightening_periods) < other_heading_rad)
    return 0;
  std::size_t periods = 0;
  while (left_rad(periods) > straightening_left * left_rad(0)) ++periods;
  return static_cast<int>(periods) + 1;
}

WheelPair SteadyStateMap::command_for(const WheelPair& speed_m_s) const {
  return {command_on(left_, speed_m_s.left), command_on(right_, speed_m_s.right)};
}

// Where commands act in steps, or up to some size not at all, a model knows least of the edges of these
// levels. Of the fastest speed it knows the edge and nothing of what lies far beyond: a short command there
// may show or not, as what limits the speed lies behind the motor's lag or before it. So no more is sent than
// what lies half a level, as wide as the one before, beyond the edge.
double SteadyStateMap::middle_of_level(const std::vector<Point>& curve,
                                       std::vector<Point>::const_iterator point) {
  const auto [first, last] = level_at(curve, point);
  if (first->command <= 0.0 && last->command >= 0.0) return 0.0;
  const double half_m_s = 0.5 * (last->command - first->command);
  if (last + 1 == curve.end()) {
    const auto before = level_at(curve, first - 1);
    return first->command + std::min(half_m_s, 0.5 * (before.last->command - before.first->command));
  }
  if (first == curve.begin()) {
    const auto before = level_at(curve, last + 1);
    return last->command - std::min(half_m_s, 0.5 * (before.last->command - before.first->command));
  }
  return first->command + half_m_s;
}

// The points around this one between which the speed hardly changes with the command.
SteadyStateMap::Level SteadyStateMap::level_at(const std::vector<Point>& curve,
                                               std::vector<Point>::const_iterator point) {
  constexpr double flat = 0.1;  // speed per command
  const auto level = [](const Point& low, const Point& high) {
    return high.speed - low.speed < flat * (high.command - low.command);
  };
  Level found{point, point};
  while (found.first != curve.begin() && level(*(found.first - 1), *found.first)) --found.first;
  while (found.last + 1 != curve.end() && level(*found.last, *(found.last + 1))) ++found.last;
  return found;
}

double SteadyStateMap::command_on(const std::vector<Point>& curve, double speed) {
  if (speed == 0.0) return 0.0;
  const auto above = std::ranges::lower_bound(curve, speed, {}, &Point::speed);
  if (above == curve.begin()) return above->command;
  if (above == curve.end()) {
    // The smallest command that gives the fastest speed there is.
    return std::ranges::lower_bound(curve, curve.back().speed, {}, &Point::speed)->command;
  }
  const Point& low = *(above - 1);
  const Point& high = *above;
  const double jump = high.speed - low.speed;
  // Across the edge of a level, as of rest in a dead zone, there is nothing between its speed and the next.
  const double usual = high.command - low.command;
  if (jump > 2.0 * usual) return middle_of_level(curve, speed - low.speed < 0.5 * jump ? above - 1 : above);
  return low.command + (high.command - low.command) * (speed - low.speed) / jump;
}

}  // namespace wheelwright
