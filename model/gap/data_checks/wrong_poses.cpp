#include "model/gap/data_checks/wrong_poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/log/lost_poses.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

void forget_pose(DriveSample& sample) {
  sample.reference_x_m.reset();
  sample.reference_y_m.reset();
  sample.reference_theta_rad.reset();
}

// Poses in the order of time, and the rows that hold them.
struct Poses {
  std::vector<std::size_t> rows;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> heading;  // without wraps
};

Poses poses_of(const DriveLog& log) {
  Poses poses;
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const auto pose = log.samples[row].reference_pose();
    if (!pose) continue;
    const double before = poses.heading.empty() ? pose->theta_rad : poses.heading.back();
    poses.rows.push_back(row);
    poses.x.push_back(pose->x_m);
    poses.y.push_back(pose->y_m);
    poses.heading.push_back(before + wrap_angle(pose->theta_rad - before));
  }
  return poses;
}

std::size_t forget(GateState& gate, const Poses& poses, std::span<const RowStretch> stretches) {
  std::size_t count = 0;
  for (const RowStretch& stretch : stretches) {
    for (std::size_t i = stretch.begin; i < std::min(stretch.end, poses.rows.size()); ++i) {
      DriveSample& sample = gate.result.log.samples[poses.rows[i]];
      if (sample.reference_x_m) ++count;
      forget_pose(sample);
    }
  }
  return count;
}

std::string left_out(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " pose was left out" : " poses were left out");
}

std::string times(std::size_t count) {
  return count == 1 ? "" : " (" + std::to_string(count) + " times)";
}

void leave_out_lost(GateState& gate) {
  const Poses poses = poses_of(gate.result.log);
  const auto lost = lost_stretches(poses.x, poses.y);
  if (lost.empty()) return;
  gate.treated_fault(poses.rows[lost.front().begin], in_words(lost, poses.x),
                     left_out(forget(gate, poses, lost)));
}

void leave_out_held(GateState& gate) {
  const Poses poses = poses_of(gate.result.log);
  const auto held = held_stretches(poses.x, poses.y, poses.heading);
  if (held.empty()) return;
  double longest_s = 0.0;
  for (const RowStretch& stretch : held) {
    const auto time = [&](std::size_t i) { return gate.result.log.samples[poses.rows[i]].t_s; };
    longest_s = std::max(longest_s, time(stretch.end) - time(stretch.begin - 1));
  }
  gate.treated_fault(poses.rows[held.front().begin],
                     "the reference holds its last pose and then jumps" + times(held.size()) + ", after " +
                         in_digits(longest_s, 2) + " s at most",
                     left_out(forget(gate, poses, held)));
}

void leave_out_outliers(GateState& gate) {
  const Poses poses = poses_of(gate.result.log);
  std::vector<RowStretch> all;
  for (const auto* values : {&poses.x, &poses.y, &poses.heading}) {
    const auto found = outlier_stretches(*values);
    all.insert(all.end(), found.begin(), found.end());
  }
  if (all.empty()) return;
  std::ranges::sort(all, {}, &RowStretch::begin);
  double moved_m = 0.0;
  double turned_rad = 0.0;
  for (const RowStretch& outlier : all) {
    const std::size_t at = outlier.begin;
    moved_m = std::max(moved_m, std::hypot(poses.x[at] - poses.x[at - 1], poses.y[at] - poses.y[at - 1]));
    turned_rad = std::max(turned_rad, std::abs(poses.heading[at] - poses.heading[at - 1]));
  }
  gate.treated_fault(poses.rows[all.front().begin],
                     "poses of the reference lie beside those before and after" + times(all.size()) +
                         ", by up to " + in_digits(moved_m, 2) + " m and " + in_digits(turned_rad, 2) +
                         " rad",
                     left_out(forget(gate, poses, all)));
}

// From where it was last told, each of place and heading by itself.
struct Leap {
  double moved_m = 0.0;
  double turned_rad = 0.0;
  double duration_s = 0.0;
  bool impossible = false;
};

bool tells_place(const DriveSample& sample) {
  return sample.reference_x_m && sample.reference_y_m;
}

class LastReference {
 public:
  Leap leap_to(const DriveSample& sample) const {
    Leap leap;
    if (place_ != nullptr && tells_place(sample)) {
      leap.duration_s = sample.t_s - place_->t_s;
      leap.moved_m = std::hypot(*sample.reference_x_m - *place_->reference_x_m,
                                *sample.reference_y_m - *place_->reference_y_m);
      leap.impossible = leap.moved_m > impossible_speed_m_s * leap.duration_s + 0.05;
    }
    if (heading_ != nullptr && sample.reference_theta_rad) {
      leap.duration_s = sample.t_s - heading_->t_s;
      leap.turned_rad = std::abs(wrap_angle(*sample.reference_theta_rad - *heading_->reference_theta_rad));
      leap.impossible |= leap.turned_rad > 12.0 * leap.duration_s + 0.3;
    }
    return leap;
  }
  void is(const DriveSample& sample) {
    if (tells_place(sample)) place_ = &sample;
    if (sample.reference_theta_rad) heading_ = &sample;
  }

 private:
  const DriveSample* place_ = nullptr;
  const DriveSample* heading_ = nullptr;
};

class ReferenceJumps {
 public:
  explicit ReferenceJumps(GateState& gate) : gate_(gate), samples_(gate.result.log.samples) {}

  void remove() {
    constexpr std::size_t longest_leap = 5;
    std::size_t in_a_row = 0;
    std::size_t good = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      DriveSample& sample = samples_[i];
      if (!tells(sample)) continue;
      const Leap leap = last_.leap_to(sample);
      if (leap.impossible && in_a_row == 0) {
        if (const auto back = leap_back(good, i)) {
          leave_out(leap, i, *back);
          i = *back - 1;
          continue;
        }
      }
      if (leap.impossible && in_a_row < longest_leap) {
        if (in_a_row++ == 0) say(leap, i, "the row was left out");
        forget_pose(sample);
        continue;
      }
      in_a_row = 0;
      last_.is(sample);
      good = i;
    }
  }

 private:
  static bool tells(const DriveSample& sample) { return tells_place(sample) || sample.reference_theta_rad; }

  // Where the reference leaps again, to a place that the wheels went to from row `good`.
  std::optional<std::size_t> leap_back(std::size_t good, std::size_t from) const {
    constexpr double longest_s = 5.0;
    LastReference there;
    there.is(samples_[from]);
    for (std::size_t i = from + 1; i < samples_.size() && samples_[i].t_s - samples_[good].t_s < longest_s;
         ++i) {
      if (!tells(samples_[i])) continue;
      if (there.leap_to(samples_[i]).impossible && went(good, i)) return i;
      there.is(samples_[i]);
    }
    return std::nullopt;
  }

  bool went(std::size_t from, std::size_t to) const {
    constexpr double unsure_m = 0.05;
    constexpr double unsure_rad = 0.2;
    constexpr double of_the_way = 0.3;
    const auto before = samples_[from].reference_pose();
    const auto after = samples_[to].reference_pose();
    if (!before || !after) return false;
    Pose own;
    double way_m = 0.0;
    double turn_rad = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i) {
      const Twist step = twist_of_wheels(rolled(i), gate_.result.log.wheel_base_m);
      own = move_along_arc(own, step, 1.0);
      way_m += std::abs(step.v_m_s);
      turn_rad += std::abs(step.w_rad_s);
    }
    const double c = std::cos(before->theta_rad);
    const double s = std::sin(before->theta_rad);
    const double dx = after->x_m - before->x_m - (c * own.x_m - s * own.y_m);
    const double dy = after->y_m - before->y_m - (s * own.x_m + c * own.y_m);
    return std::hypot(dx, dy) < unsure_m + of_the_way * way_m &&
           std::abs(wrap_angle(after->theta_rad - before->theta_rad - own.theta_rad)) <
               unsure_rad + of_the_way * turn_rad;
  }

  // Since the row before, m.
  WheelPair rolled(std::size_t row) const {
    const DriveSample& before = samples_[row - 1];
    const double duration_s = samples_[row].t_s - before.t_s;
    if (gate_.result.log.metres_per_tick && samples_[row].ticks && before.ticks)
      return {gate_.travel(row, true) - gate_.travel(row - 1, true),
              gate_.travel(row, false) - gate_.travel(row - 1, false)};
    return {before.command_m_s.left * duration_s, before.command_m_s.right * duration_s};
  }

  void leave_out(const Leap& leap, std::size_t from, std::size_t to) {
    const double duration_s = samples_[to].t_s - samples_[from].t_s;
    std::size_t count = 0;
    for (std::size_t i = from; i < to; ++i) {
      if (tells(samples_[i])) ++count;
      forget_pose(samples_[i]);
    }
    say(leap, from,
        count == 1 ? "the row was left out"
                   : "it jumps back " + in_digits(duration_s, 2) + " s later; " + left_out(count));
  }

  void say(const Leap& leap, std::size_t row, const std::string& treatment) {
    gate_.treated_fault(row,
                        "the reference jumps by " + in_digits(leap.moved_m, 3) + " m and " +
                            in_digits(leap.turned_rad, 3) + " rad in " + in_digits(leap.duration_s, 3) + " s",
                        treatment);
  }

  GateState& gate_;
  std::vector<DriveSample>& samples_;
  LastReference last_;
};

}  // namespace

void leave_out_wrong_poses(GateState& gate) {
  leave_out_lost(gate);
  leave_out_held(gate);
  leave_out_outliers(gate);
}

void remove_reference_jumps(GateState& gate) {
  ReferenceJumps(gate).remove();
}

}  // namespace wheelwright::gap
