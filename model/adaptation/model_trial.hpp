// Is one model better than another on driving that neither has seen? Both run free, from commands alone;
// judged is the travel of each wheel since the start of a block against the encoders, and how far the robot
// turned over all blocks: half a percent between the wheels leads a route farther astray than two percent of
// both, and shows in no block by itself.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "model/geometry/pose.hpp"
#include "model/log/sensor_frame.hpp"
#include "model/simulation/model_simulation.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

class ModelTrial {
 public:
  // With their effects. Throws std::invalid_argument where `present` has no encoder scale, which both are
  // judged by.
  ModelTrial(const RobotModel& present, const RobotModel& candidate);
  // The same from where the robot is: `start` has pose, way of the wheels and time at the first frame.
  ModelTrial(const RobotModel& present, const RobotModel& candidate, const ModelSimulation& start);

  // Each frame in order. A block with a frame that is not `sound` does not count.
  void take(const SensorFrame& frame, bool sound);

  // Blocks of 2 s so far in which the robot drove.
  int blocks() const { return blocks_; }
  // The candidate is better in travel by more than one standard error of the difference over the blocks, and
  // over all of them it turns no farther from the counts than the present model, but for their noise.
  bool is_better() const;
  // Root mean square of the travel error within a block, in metres; nothing before the first block.
  std::optional<double> present_error_m() const { return rms(present_.square_sum); }
  std::optional<double> candidate_error_m() const { return rms(candidate_.square_sum); }

 private:
  struct Runner {
    explicit Runner(const RobotModel& model) : simulation(model) {}
    ModelSimulation simulation;
    WheelPair travel_m;  // since the start of the block
    double block_squares = 0.0;
    double ahead_m = 0.0;      // the right wheel of the left one, beyond the counts, within the block
    double square_sum = 0.0;   // of the mean squares of all blocks
    double ahead_sum_m = 0.0;  // at the ends of all blocks
  };

  std::optional<double> rms(double square_sum) const;
  void begin_block(const SensorFrame& frame);
  void end_block();
  void compare(Runner& runner, const WheelPair& counted_m);

  double period_s_;
  WheelPair metres_per_tick_;
  Runner present_;
  Runner candidate_;
  WheelPair command_;
  double battery_v_ = std::numeric_limits<double>::quiet_NaN();
  std::int64_t tick_ = 0;
  bool started_ = false;
  int settle_ticks_;  // until both models have forgotten that they began at rest
  int block_ticks_ = 0;
  double commanded_m_ = 0.0;  // within the block
  WheelTicks start_;
  int blocks_ = 0;
  double difference_sum_ = 0.0;
  double difference_squares_ = 0.0;
};

}  // namespace wheelwright
