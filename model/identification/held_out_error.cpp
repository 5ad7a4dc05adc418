#include "model/identification/held_out_error.hpp"

#include <algorithm>

#include "model/identification/settled_response.hpp"
#include "model/log/run_periods.hpp"
#include "model/prediction/free_run.hpp"

namespace wheelwright {
namespace {

constexpr double longest_block_s = 5.0;
constexpr double min_blocks = 6.0;

// Mean square of travel errors since the first row of a block.
class Block {
 public:
  void add(const WheelPair& error_m) {
    if (count_ == 0) start_ = error_m;
    const double left = error_m.left - start_.left;
    const double right = error_m.right - start_.right;
    squares_ += 0.5 * (left * left + right * right);
    ++count_;
  }
  std::size_t count() const { return count_; }
  double mean_square() const { return squares_ / static_cast<double>(count_); }

 private:
  WheelPair start_;
  double squares_ = 0.0;
  std::size_t count_ = 0;
};

WheelPair travel_error_m(const PredictedMotion& predicted, const DriveLog& log, std::size_t row) {
  const WheelTicks& now = *log.samples[row].ticks;
  const WheelTicks& first = *log.samples.front().ticks;
  return {
      predicted.distance_m.left - static_cast<double>(now.left - first.left) * log.metres_per_tick->left,
      predicted.distance_m.right - static_cast<double>(now.right - first.right) * log.metres_per_tick->right};
}

}  // namespace

std::vector<double> block_distance_squares(const LinearModel& model, const DriveLog& log, double from_s) {
  const auto motion = free_run(model, log);
  const double judged_s = log.samples.back().t_s - from_s;
  const double block_s = std::min(longest_block_s, judged_s / min_blocks);
  std::vector<double> squares;
  Block block;
  double block_start_s = from_s;
  const auto close = [&](double next_start_s) {
    // Half a block says as much per row; a few rows of one say nothing.
    if (static_cast<double>(block.count()) * log.period_s > 0.5 * block_s) {
      squares.push_back(block.mean_square());
    }
    block = {};
    block_start_s = next_start_s;
  };
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    const double t_s = log.samples[k].t_s;
    if (k > 0 && t_s - log.samples[k - 1].t_s > longest_step_periods * log.period_s) {
      close(std::max(from_s, t_s + forgetting_periods * model.period_s));
    }
    if (!log.samples[k].ticks || t_s < block_start_s) continue;
    if (t_s >= block_start_s + block_s) close(t_s);
    block.add(travel_error_m(motion[k], log, k));
  }
  close(0.0);
  return squares;
}

}  // namespace wheelwright
