#include "model/gap/data_checks/frozen_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "model/geometry/pose.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double still_m = 0.003;  // noise of a pose that does not change
constexpr double still_rad = 0.01;
constexpr double rolled_m = 0.4;    // way of the wheels that no standing pose can have
constexpr double rolled_rad = 1.0;  // turn by the wheels
constexpr std::size_t min_poses = 10;
constexpr double min_share = 0.5;  // of the way, from which nothing can be judged

// What the wheels rolled and turned from row to row, without regard to direction.
struct Rolled {
  double way_m = 0.0;
  double turn_rad = 0.0;
};

class FrozenReference {
 public:
  explicit FrozenReference(GateState& gate) : gate_(gate), samples_(gate.result.log.samples) {}

  void remove() {
    if (heading_never_turns()) return;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      roll(i);
      if (!has_reference(i)) continue;
      if (!first_ || !stands(i)) {
        close();
        first_ = i;
        rolled_ = {};
        poses_ = 0;
      }
      last_ = i;
      ++poses_;
      until_last_ = rolled_;
    }
    close();
    if (frozen_m_ > 0.0 && frozen_m_ >= min_share * all_m_)
      gate_.fault(0,
                  "the reference stands still for " + in_digits(100.0 * frozen_m_ / all_m_, 2) +
                      " % of the way that the wheels roll: it is frozen, or the robot was held",
                  true);
  }

 private:
  // As of a source that has no heading and writes a number for it. Of a robot that has made whole turns the
  // same heading is expected: several poses have to be of moments at which the counts say another.
  bool heading_never_turns() {
    double heading = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    double at_first = 0.0;
    std::size_t elsewhere = 0;
    const DriveSample* first = nullptr;
    bool moves = false;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (i > 0 && samples_[i].ticks && samples_[i - 1].ticks) {
        const double left = gate_.travel(i, true) - gate_.travel(i - 1, true);
        const double right = gate_.travel(i, false) - gate_.travel(i - 1, false);
        if (is_possible(i, left, right)) heading += (right - left) / gate_.result.log.wheel_base_m;
      }
      if (!samples_[i].reference_theta_rad || !samples_[i].reference_x_m) continue;
      if (first == nullptr) {
        first = &samples_[i];
        at_first = heading;
      }
      if (std::abs(wrap_angle(heading - at_first)) > rolled_rad) ++elsewhere;
      if (std::abs(wrap_angle(*samples_[i].reference_theta_rad - *first->reference_theta_rad)) > still_rad)
        return false;
      moves = moves || std::abs(*samples_[i].reference_x_m - *first->reference_x_m) > rolled_m / 4;
      lowest = std::min(lowest, heading);
      highest = std::max(highest, heading);
    }
    if (!moves || elsewhere < min_poses) return false;
    gate_.fault(0,
                "the heading of the reference does not turn while the wheels turn " +
                    in_digits(highest - lowest, 3) + " rad by their counts",
                true);
    return true;
  }

  // A jump of the counts is no way.
  bool is_possible(std::size_t i, double left_m, double right_m) const {
    const double max_m = impossible_speed_m_s * (samples_[i].t_s - samples_[i - 1].t_s);
    return std::abs(left_m) <= max_m && std::abs(right_m) <= max_m;
  }

  bool has_reference(std::size_t i) const {
    return (samples_[i].reference_x_m && samples_[i].reference_y_m) || samples_[i].reference_theta_rad;
  }

  void roll(std::size_t i) {
    if (i == 0 || !samples_[i].ticks || !samples_[i - 1].ticks) return;
    const double left = gate_.travel(i, true) - gate_.travel(i - 1, true);
    const double right = gate_.travel(i, false) - gate_.travel(i - 1, false);
    if (!is_possible(i, left, right)) return;
    const double way = std::abs(0.5 * (left + right));
    rolled_.way_m += way;
    rolled_.turn_rad += std::abs(right - left) / gate_.result.log.wheel_base_m;
    all_m_ += way;
  }

  bool stands(std::size_t i) const {
    const DriveSample& from = samples_[*first_];
    const DriveSample& to = samples_[i];
    if (from.reference_x_m.has_value() != to.reference_x_m.has_value() ||
        from.reference_theta_rad.has_value() != to.reference_theta_rad.has_value())
      return false;
    if (from.reference_x_m && (std::abs(*to.reference_x_m - *from.reference_x_m) > still_m ||
                               std::abs(*to.reference_y_m - *from.reference_y_m) > still_m))
      return false;
    return !from.reference_theta_rad ||
           std::abs(wrap_angle(*to.reference_theta_rad - *from.reference_theta_rad)) <= still_rad;
  }

  // A place says nothing of a turn in place, a heading nothing of a straight line.
  void close() {
    if (!first_ || poses_ < min_poses) return;
    const DriveSample& from = samples_[*first_];
    const bool is_way = from.reference_x_m && until_last_.way_m > rolled_m;
    const bool is_turn = from.reference_theta_rad && until_last_.turn_rad > rolled_rad;
    if (!is_way && !is_turn) return;
    gate_.treated_fault(*first_ + 1,
                        "the reference stands still while the wheels roll " +
                            in_digits(until_last_.way_m, 3) + " m and turn " +
                            in_digits(until_last_.turn_rad, 3) +
                            " rad by their counts: frozen, or the robot was held",
                        std::to_string(poses_ - 1) + " poses were left out");
    frozen_m_ += until_last_.way_m;
    for (std::size_t i = *first_ + 1; i <= last_; ++i) {
      samples_[i].reference_x_m.reset();
      samples_[i].reference_y_m.reset();
      samples_[i].reference_theta_rad.reset();
    }
  }

  GateState& gate_;
  std::vector<DriveSample>& samples_;
  std::optional<std::size_t> first_;
  std::size_t last_ = 0;
  std::size_t poses_ = 0;
  Rolled rolled_;      // since the first pose of the segment
  Rolled until_last_;  // up to its last pose
  double frozen_m_ = 0.0;
  double all_m_ = 0.0;
};

}  // namespace

void remove_frozen_reference(GateState& gate) {
  if (gate.result.log.has_ticks()) FrozenReference(gate).remove();
}

}  // namespace wheelwright::gap
