// Is one model better than another on driving that neither has seen? Both run free, from commands alone;
// judged are the travel of each wheel and the turn of the robot since the start of a block, against the
// encoders. The turn by itself, since half a percent between the wheels leads a route farther astray than two
// percent of both.
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
  // not worse by as much in turns.
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
    double block_turn_squares = 0.0;
    double square_sum = 0.0;  // of the mean squares of all blocks
  };
  // Of the present model's mean squares less the candidate's, over the blocks.
  struct Advantage {
    double sum = 0.0;
    double squares = 0.0;
    void add(double difference) {
      sum += difference;
      squares += difference * difference;
    }
    double mean(int blocks) const { return sum / blocks; }
    double standard_error(int blocks) const;
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
  Advantage in_travel_;
  Advantage in_turns_;
};

}  // namespace wheelwright
