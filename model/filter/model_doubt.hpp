// Where a small error of a parameter makes a large difference: at the edge of a quantization step, of a dead
// zone, of stiction.
//
// There no standard deviation of the parameter describes what the wheels may do: they do the one thing or the
// other. The model is run beside itself with each parameter of its effects moved up and down by three
// standard deviations. What a parameter changes smoothly it changes by as much up as down; that is left to
// the gain error and the roughness that the filter learns (scale_drift_detector.hpp). What remains,
//
//   doubt = max_k |v(up_k) + v(down_k) - 2 v|,    v: speed of a wheel
//
// is 0 for a model that is linear in its parameters, and the height of a step where one of the two is across
// the step's edge and the model is not.
#pragma once

#include <vector>

#include "model/geometry/pose.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

// Allocates when it is made and never after.
class ModelDoubt {
 public:
  // Never in doubt.
  ModelDoubt() = default;
  explicit ModelDoubt(const RobotModel& model);

  // Sets the pose, and the travel of the wheels, to those of the filter.
  void set_place(const Pose& pose, const WheelPair& distance_m);
  // Moves on by one period with this command in force. `wheel_m_s` is what the model itself does over the
  // period. Returns by how much the speed of each wheel may be another.
  WheelPair step(const WheelPair& command_m_s, double battery_v, const WheelPair& wheel_m_s);

 private:
  struct Moved {
    ModelSimulation up;
    ModelSimulation down;
  };
  std::vector<Moved> moved_;
};

}  // namespace wheelwright
