// Pose from encoder counts alone.
#pragma once

#include <optional>

#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

class Odometry {
 public:
  Odometry(double wheel_base_m, const WheelPair& metres_per_tick)
      : wheel_base_m_(wheel_base_m), metres_per_tick_(metres_per_tick) {}

  // Takes the counts of a sample. Returns how far each wheel rolled since the last one, in metres.
  WheelPair update(const WheelTicks& ticks) {
    if (!last_) last_ = ticks;
    const WheelPair rolled{static_cast<double>(ticks.left - last_->left) * metres_per_tick_.left,
                           static_cast<double>(ticks.right - last_->right) * metres_per_tick_.right};
    last_ = ticks;
    pose_ = move_along_arc(pose_, twist_of_wheels(rolled, wheel_base_m_), 1.0);
    return rolled;
  }

  // The next sample continues from the same pose, whatever its counts: for the first one after a gap.
  void rebase() { last_.reset(); }

  // From now on; and what was counted so far was counted with a wrong scale. Exact for turns in place.
  void correct_metres_per_tick(const WheelPair& metres_per_tick) {
    const double ratio =
        (metres_per_tick.left + metres_per_tick.right) / (metres_per_tick_.left + metres_per_tick_.right);
    pose_ = {ratio * pose_.x_m, ratio * pose_.y_m, ratio * pose_.theta_rad};
    metres_per_tick_ = metres_per_tick;
  }
  void set_pose(const Pose& pose) { pose_ = pose; }
  const Pose& pose() const { return pose_; }

 private:
  double wheel_base_m_;
  WheelPair metres_per_tick_;
  std::optional<WheelTicks> last_;
  Pose pose_;
};

}  // namespace wheelwright
