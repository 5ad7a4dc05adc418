#include "model/gap/data_checks/carried_robot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/statistics/order_statistics.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double stood_s = 0.5;
constexpr double carried_m = 0.1;
constexpr double carried_rad = 0.3;
constexpr double times_the_noise = 10.0;
constexpr double slow = 0.2;  // of what counts as carried, within the time that a robot has to stand
constexpr double commands_late_s = 0.5;  // by which commands may be logged behind the motion that they cause

// How far one pose is from another.
struct Apart {
  double moved_m = 0.0;
  double turned_rad = 0.0;
};

class CarriedRobot {
 public:
  explicit CarriedRobot(GateState& gate)
      : gate_(gate), samples_(gate.result.log.samples), has_counts_(gate.result.log.has_ticks()) {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i].reference_pose()) rows_.push_back(i);
    }
    noise_ = noise_of_a_pose();
  }

  void restart_behind() {
    std::size_t at = 0;
    while (at < rows_.size()) {
      const std::size_t end = end_of_rest(at);
      if (const auto stand = carried_from(at, end)) treat(*stand, end);
      at = std::max(end, at + 1);
    }
  }

 private:
  // Poses at `rows_[at]` to before the returned one are of one rest: no command, and no count.
  std::size_t end_of_rest(std::size_t at) const {
    std::size_t row = rows_[at];
    if (!is_zero(samples_[row].command_m_s)) return at;
    const auto& ticks = samples_[row].ticks;
    while (row < samples_.size() && is_zero(samples_[row].command_m_s) &&
           (!has_counts_ || (ticks && samples_[row].ticks && near(*ticks, *samples_[row].ticks))))
      ++row;
    const double end_s =
        row < samples_.size() ? samples_[row].t_s - commands_late_s : samples_.back().t_s + 1.0;
    while (at < rows_.size() && rows_[at] < row && samples_[rows_[at]].t_s < end_s) ++at;
    return at;
  }
  static bool is_zero(const WheelPair& command) {
    constexpr double no_motor_m_s = 1e-3;
    return std::abs(command.left) < no_motor_m_s && std::abs(command.right) < no_motor_m_s;
  }
  // A wheel at rest may tremble on the edge of a count.
  static bool near(const WheelTicks& a, const WheelTicks& b) {
    return std::abs(a.left - b.left) <= 1 && std::abs(a.right - b.right) <= 1;
  }

  // Poses at which the robot stands at one place.
  struct Stand {
    std::size_t first;
    std::size_t last;
  };

  // Where it stood before it left its place.
  std::optional<Stand> carried_from(std::size_t at, std::size_t end) const {
    std::size_t since = at;
    std::size_t still = at;
    bool stood = false;
    for (std::size_t i = at; i < end; ++i) {
      const Apart apart = between(since, i);
      if (stood && is_beyond(apart, 1.0) && is_beyond(between(since, end - 1), 1.0))
        return Stand{since, still};
      if (!stood && is_beyond(apart, slow)) since = i;
      if (!is_beyond(apart, slow)) still = i;
      stood = stood || samples_[rows_[i]].t_s - samples_[rows_[since]].t_s >= stood_s;
    }
    return std::nullopt;
  }

  Apart between(std::size_t a, std::size_t b) const {
    const Pose from = *samples_[rows_[a]].reference_pose();
    const Pose to = *samples_[rows_[b]].reference_pose();
    return {std::hypot(to.x_m - from.x_m, to.y_m - from.y_m),
            std::abs(wrap_angle(to.theta_rad - from.theta_rad))};
  }
  bool is_beyond(const Apart& apart, double share) const {
    return apart.moved_m > share * std::max(carried_m, times_the_noise * noise_.moved_m) ||
           apart.turned_rad > share * std::max(carried_rad, times_the_noise * noise_.turned_rad);
  }

  // Medians from one pose to the next, the motion between them included.
  Apart noise_of_a_pose() const {
    if (rows_.size() < 2) return {};
    std::vector<double> moved_m;
    std::vector<double> turned_rad;
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const Apart apart = between(i - 1, i);
      moved_m.push_back(apart.moved_m);
      turned_rad.push_back(apart.turned_rad);
    }
    return {median(std::move(moved_m)), median(std::move(turned_rad))};
  }

  void treat(const Stand& stand, std::size_t end) {
    const Apart apart = between(stand.first, end - 1);
    const std::size_t first = rows_[stand.last] + 1;
    const std::size_t last = rows_[end - 1];
    gate_.treated_fault(first,
                        "the robot moves " + in_digits(apart.moved_m, 2) + " m and turns " +
                            in_digits(apart.turned_rad, 2) + " rad while its wheels stand" +
                            (has_counts_ ? "" : " by their commands") + ": it was carried or pushed",
                        "what follows starts from the next pose");
    for (std::size_t row = first; row <= last; ++row) {
      gate_.result.flags.restart[row] = 1;
      if (row == last) continue;
      samples_[row].reference_x_m.reset();
      samples_[row].reference_y_m.reset();
      samples_[row].reference_theta_rad.reset();
    }
  }

  GateState& gate_;
  std::vector<DriveSample>& samples_;
  bool has_counts_;
  std::vector<std::size_t> rows_;  // that hold a pose
  Apart noise_;
};

}  // namespace

void restart_where_carried(GateState& gate) {
  CarriedRobot(gate).restart_behind();
}

}  // namespace wheelwright::gap
