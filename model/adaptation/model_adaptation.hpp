// How the present model would have to be changed for its free run to agree with the encoders over a piece of
// driving: what a change of the robot (worn gears, another floor, a colder day) makes of it.
//
// Two kinds of change are fitted together:
//   * the linear part of each wheel, with y the speed that it makes of the commands,
//
//       corrected(k) = sum_j weight[j] y(k - 2 j),   j = 0, 1, 2
//
//     which holds another gain, more delay and a slower answer, and leaves the type of the model and its
//     poles as they are; before anything is learnt the weights are 1, 0, 0,
//   * the sizes of the effects that act on the wheels behind the linear part (stage `wheel`): friction, play
//     and the limits of motors change as a robot is used. What the firmware makes of a command stays as it
//     is, and so does what hangs on place, heading or the angle of a wheel, and what encoders do not see.
//
// Least squares on travel, with a prior around the present model, which says how large changes are; so what
// the driving does not excite stays as it was. The free run is that of the whole model, from where the
// filter has the robot; adaptation_fit.hpp has the method. Regressors are free of the encoders' noise, so
// that there is no bias by errors in variables, which an ARX fit on measured past speeds has
// (model/identification/arma_accumulator.hpp). Both sides are summed up to travel with a leak of one second:
// differences of counts are mostly noise, and sums without a leak carry an error on for ever.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "model/log/sensor_frame.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

class ModelAdaptation {
 public:
  // `start` has pose, way of the wheels and time of the robot at the first frame. Throws
  // std::invalid_argument where the model has no encoder scale. Allocates room for two minutes of driving,
  // and keeps no more.
  ModelAdaptation(const RobotModel& model, const ModelSimulation& start);

  // Each frame in order. Of one that is not `sound` (a sensor fault, a robot that is not driven) only the
  // command is used, and nothing is learnt.
  void take(const SensorFrame& frame, bool sound);

  // The present model, changed so that it agrees with what was driven so far. Takes some ten free runs of it
  // for each iteration.
  RobotModel adapted() const;

  // Periods that are kept.
  std::size_t size() const { return periods_.size(); }

 private:
  struct Period {
    WheelPair command_m_s;  // in force
    double battery_v;
    std::optional<WheelPair> rolled_m;  // by the counts, since the period before; none where they say nothing
  };

  void remember(const SensorFrame& frame, std::int64_t ticks, bool usable);

  RobotModel model_;
  ModelSimulation start_;
  std::size_t max_periods_;
  std::vector<Period> periods_;
  WheelPair command_;
  double battery_v_ = std::numeric_limits<double>::quiet_NaN();  // of the last reading
  WheelTicks ticks_;
  std::int64_t tick_ = 0;
  bool started_ = false;
  bool was_usable_ = false;
  int quiet_ticks_ = 0;     // until counts whose signs were in doubt are behind
  int standing_ticks_ = 0;  // for which nothing was commanded and nothing rolled
};

}  // namespace wheelwright
