#include "model/adaptation/model_trial.hpp"

#include <algorithm>
#include <cmath>

#include "model/adaptation/free_run_start.hpp"
#include "model/simulation/known_scale.hpp"

namespace wheelwright {
namespace {

constexpr double block_s = 2.0;
constexpr double min_way_m =
    0.1;  // of both wheels together within a block; a robot that stands shows nothing
// Of two counters that were each read some ms late, at 0.2 m/s.
constexpr double noise_of_difference_m = 0.0015;

}  // namespace

ModelTrial::ModelTrial(const RobotModel& present, const RobotModel& candidate)
    : period_s_(present.linear_part.period_s),
      metres_per_tick_(known_scale(present)),
      present_(present),
      candidate_(candidate),
      settle_ticks_(static_cast<int>(settle_s / present.linear_part.period_s)) {}

ModelTrial::ModelTrial(const RobotModel& present, const RobotModel& candidate, const ModelSimulation& start)
    : ModelTrial(present, candidate) {
  for (Runner* runner : {&present_, &candidate_}) runner->simulation.take_over(start);
}

void ModelTrial::begin_block(const SensorFrame& frame) {
  start_ = frame.ticks;
  block_ticks_ = 0;
  commanded_m_ = 0.0;
  for (Runner* runner : {&present_, &candidate_}) {
    runner->travel_m = {};
    runner->block_squares = 0.0;
  }
}

void ModelTrial::compare(Runner& runner, const WheelPair& counted_m) {
  const double left = runner.travel_m.left - counted_m.left;
  const double right = runner.travel_m.right - counted_m.right;
  runner.block_squares += 0.5 * (left * left + right * right);
  runner.ahead_m = right - left;
}

void ModelTrial::end_block() {
  if (commanded_m_ < min_way_m) return;
  const double present = present_.block_squares / block_ticks_;
  const double candidate = candidate_.block_squares / block_ticks_;
  present_.square_sum += present;
  candidate_.square_sum += candidate;
  present_.ahead_sum_m += present_.ahead_m;
  candidate_.ahead_sum_m += candidate_.ahead_m;
  difference_sum_ += present - candidate;
  difference_squares_ += (present - candidate) * (present - candidate);
  ++blocks_;
}

void ModelTrial::take(const SensorFrame& frame, bool sound) {
  const std::int64_t ticks =
      started_ ? std::clamp<std::int64_t>(frame.tick - tick_, 0, max_ticks_left_out) : 0;
  for (std::int64_t i = 0; i < ticks; ++i) {
    for (Runner* runner : {&present_, &candidate_}) {
      const WheelPair& speed = runner->simulation.step(command_, battery_v_).wheel_m_s;
      runner->travel_m.left += period_s_ * speed.left;
      runner->travel_m.right += period_s_ * speed.right;
    }
    commanded_m_ += period_s_ * (std::abs(command_.left) + std::abs(command_.right));
  }
  tick_ = frame.tick;
  command_ = frame.command.speed_m_s;
  if (frame.valid && frame.battery_v > 0.0) battery_v_ = frame.battery_v;
  const bool usable = started_ && sound && frame.valid && frame.armed && !frame.after_gap;
  started_ = true;
  if (settle_ticks_ > 0) --settle_ticks_;
  if (!usable || settle_ticks_ > 0) return begin_block(frame);
  const WheelPair counted_m{metres_per_tick_.left * static_cast<double>(frame.ticks.left - start_.left),
                            metres_per_tick_.right * static_cast<double>(frame.ticks.right - start_.right)};
  compare(present_, counted_m);
  compare(candidate_, counted_m);
  if (++block_ticks_ * period_s_ < block_s) return;
  end_block();
  begin_block(frame);
}

bool ModelTrial::is_better() const {
  if (blocks_ < 2) return false;
  const double n = blocks_;
  const double mean = difference_sum_ / n;
  const double variance = std::max(0.0, difference_squares_ / n - mean * mean) / (n - 1.0);
  const double noise_m = 2.0 * noise_of_difference_m * std::sqrt(n);
  return mean > std::sqrt(variance) &&
         std::abs(candidate_.ahead_sum_m) < std::abs(present_.ahead_sum_m) + noise_m;
}

std::optional<double> ModelTrial::rms(double square_sum) const {
  if (blocks_ == 0) return std::nullopt;
  return std::sqrt(square_sum / blocks_);
}

}  // namespace wheelwright
