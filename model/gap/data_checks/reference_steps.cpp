#include "model/gap/data_checks/reference_steps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/log/counted_windows.hpp"
#include "model/statistics/order_statistics.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double over_usual = 8.0;
constexpr double faster_m_s = 0.5;  // than the wheels ever turned: no floor moves a robot like that
constexpr double faster_rad_s = 5.0;

// From one pose of the reference to the next.
struct Motion {
  std::size_t row;
  double beyond_m;  // what the counts do not show
  double beyond_rad;
  double speed_m_s;
  double turn_rate_rad_s;
  double counted_m_s;
  double counted_rad_s;
};

std::vector<Motion> motions(const DriveLog& log) {
  const CountedPath path(log);
  std::vector<Motion> all;
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const auto pose = log.samples[i].reference_pose();
    if (!pose) continue;
    const double to_s = log.samples[i].t_s;
    if (before && path.covers(log.samples[*before].t_s, to_s)) {
      const double from_s = log.samples[*before].t_s;
      const Pose moved = between(*log.samples[*before].reference_pose(), *pose);
      const Pose counted = between(path.at(from_s), path.at(to_s));
      const double duration_s = to_s - from_s;
      const double turned_rad = wrap_angle(moved.theta_rad);
      all.push_back(
          {i, distance_between_m(moved, counted), std::abs(wrap_angle(turned_rad - counted.theta_rad)),
           std::hypot(moved.x_m, moved.y_m) / duration_s, std::abs(turned_rad) / duration_s,
           std::hypot(counted.x_m, counted.y_m) / duration_s, std::abs(counted.theta_rad) / duration_s});
    }
    before = i;
  }
  return all;
}

double usual(const std::vector<Motion>& all, double Motion::*what) {
  std::vector<double> sizes;
  sizes.reserve(all.size());
  for (const Motion& each : all) sizes.push_back(each.*what);
  return median(std::move(sizes));
}

double largest(const std::vector<Motion>& all, double Motion::*what) {
  return (*std::ranges::max_element(all, {}, what)).*what;
}

void restart_behind(GateState& gate, const Motion& step) {
  gate.treated_fault(step.row,
                     "the reference steps once, by " + in_digits(step.beyond_m, 2) + " m and " +
                         in_digits(step.beyond_rad, 2) +
                         " rad, where the wheels do not: the robot was pushed, or its reference was",
                     "what follows starts from there");
  gate.result.flags.restart[step.row] = 1;
  gate.result.log.samples[step.row].counter_reset = true;
}

}  // namespace

void treat_reference_steps(GateState& gate) {
  if (!gate.result.log.has_ticks()) return;
  const std::vector<Motion> all = motions(gate.result.log);
  if (all.empty()) return;
  const double impossible_m_s = largest(all, &Motion::counted_m_s) + faster_m_s;
  const double impossible_rad_s = largest(all, &Motion::counted_rad_s) + faster_rad_s;
  const double large_m = over_usual * usual(all, &Motion::beyond_m);
  const double large_rad = over_usual * usual(all, &Motion::beyond_rad);
  std::vector<Motion> steps;
  std::ranges::copy_if(all, std::back_inserter(steps), [&](const Motion& each) {
    return (each.beyond_m > large_m && each.speed_m_s > impossible_m_s) ||
           (each.beyond_rad > large_rad && each.turn_rate_rad_s > impossible_rad_s);
  });
  if (steps.size() == 1) return restart_behind(gate, steps.front());
  if (steps.empty()) return;
  gate.fault(steps.front().row, "the reference steps " + std::to_string(steps.size()) + " times by up to " +
                                    in_digits(largest(steps, &Motion::beyond_m), 2) + " m and " +
                                    in_digits(largest(steps, &Motion::beyond_rad), 2) +
                                    " rad where the wheels do not, as where a map is matched again");
}

}  // namespace wheelwright::gap
