#include "model/prediction/wheel_misfit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/filter/filter_noise.hpp"
#include "model/prediction/free_run.hpp"

namespace wheelwright {
namespace {

constexpr double short_window_s = 0.1;  // over which polled counters come in all ages
constexpr double long_window_s = 2.0;
constexpr std::size_t min_windows = 30;
constexpr double smallest_noise_m = 1e-4;  // of one reading
constexpr double rolling_m_s = 0.02;       // on average: a wheel that stands shows no noise

struct Step {
  double predicted_m = 0.0;
  double residual_m = 0.0;
};

double power_m2(const std::vector<Step>& steps) {
  double power_m2 = 0.0;
  for (const Step& step : steps) power_m2 += step.predicted_m * step.predicted_m;
  return power_m2;
}

// The residuals beyond a gain error.
double mean_square_m2(const std::vector<Step>& steps, double gain_error) {
  double sum_m2 = 0.0;
  for (const Step& step : steps) sum_m2 += std::pow(step.residual_m - gain_error * step.predicted_m, 2);
  return sum_m2 / static_cast<double>(steps.size());
}

// Travel from one reading to the next, so long apart.
class Steps {
 public:
  explicit Steps(double length_s) : length_s_(length_s) {}

  void begin() { has_start_ = false; }
  void take(double t_s, const Step& since_start_of_run) {
    const Step& now = since_start_of_run;
    if (has_start_) rolled_m_ += std::abs(now.predicted_m - last_predicted_m_);
    last_predicted_m_ = now.predicted_m;
    const double length_s = t_s - start_s_;
    if (has_start_ && length_s < length_s_) return;
    if (has_start_ && rolled_m_ > rolling_m_s * length_s) {
      steps_.push_back({now.predicted_m - start_.predicted_m, now.residual_m - start_.residual_m});
      seconds_ += length_s;
    }
    has_start_ = true;
    start_s_ = t_s;
    start_ = now;
    rolled_m_ = 0.0;
  }

  const std::vector<Step>& all() const { return steps_; }
  double mean_length_s() const { return seconds_ / static_cast<double>(steps_.size()); }

 private:
  double length_s_;
  bool has_start_ = false;
  double start_s_ = 0.0;
  Step start_;
  double last_predicted_m_ = 0.0;
  double rolled_m_ = 0.0;  // to and fro, since the start of the step
  std::vector<Step> steps_;
  double seconds_ = 0.0;
};

// Of one wheel, over all runs.
class Wheel {
 public:
  // The counts start again.
  void begin() {
    short_.begin();
    long_.begin();
  }
  void take(double t_s, double predicted_m, double counted_m) {
    const Step step{predicted_m, counted_m - predicted_m};
    short_.take(t_s, step);
    long_.take(t_s, step);
  }

  bool has_enough() const { return long_.all().size() >= min_windows && !short_.all().empty(); }

  WheelFit fit() const {
    const double gain = gain_error();
    const double short_m2 = mean_square_m2(short_.all(), gain);
    const double long_m2 = mean_square_m2(long_.all(), gain);
    const double walk_m2_per_s =
        std::max(0.0, (long_m2 - short_m2) / (long_.mean_length_s() - short_.mean_length_s()));
    const double reading_m2 = 0.5 * (short_m2 - walk_m2_per_s * short_.mean_length_s()) - age_m2();
    WheelFit fit;
    fit.position_noise_m = std::sqrt(std::max(smallest_noise_m * smallest_noise_m, reading_m2));
    fit.drift_m_per_sqrt_s = std::sqrt(walk_m2_per_s);
    return fit;
  }

  double gain_standard_error() const {
    const auto count = static_cast<double>(long_.all().size());
    return std::sqrt(mean_square_m2(long_.all(), gain_error()) * count / (count - 1.0) /
                     power_m2(long_.all()));
  }

 private:
  double gain_error() const {
    double product_m2 = 0.0;
    for (const Step& step : long_.all()) product_m2 += step.predicted_m * step.residual_m;
    return product_m2 / power_m2(long_.all());
  }

  double age_m2() const {
    const double age_s = FilterNoise{}.refresh_period_s;
    const double mean_speed2 = power_m2(long_.all()) / static_cast<double>(long_.all().size()) /
                               (long_.mean_length_s() * long_.mean_length_s());
    return mean_speed2 * age_s * age_s / 12.0;
  }

  Steps short_{short_window_s};
  Steps long_{long_window_s};
};

void take_run(const RobotModel& model, const DriveLog& run, Wheel& left, Wheel& right) {
  if (!run.metres_per_tick) return;
  const auto motion = free_run(model, run);
  left.begin();
  right.begin();
  for (std::size_t k = 0; k < run.samples.size(); ++k) {
    const DriveSample& sample = run.samples[k];
    if (!sample.ticks) continue;
    if (sample.counter_reset) {
      left.begin();
      right.begin();
    }
    left.take(sample.t_s, motion[k].distance_m.left,
              static_cast<double>(sample.ticks->left) * run.metres_per_tick->left);
    right.take(sample.t_s, motion[k].distance_m.right,
               static_cast<double>(sample.ticks->right) * run.metres_per_tick->right);
  }
}

}  // namespace

std::optional<WheelFits> wheel_misfit(const RobotModel& model, std::span<const DriveLog> runs) {
  Wheel left;
  Wheel right;
  for (const DriveLog& run : runs) take_run(model, run, left, right);
  if (!left.has_enough() || !right.has_enough()) return std::nullopt;
  WheelFits fits{left.fit(), right.fit()};
  fits.left.gain = dc_gain(model.linear_part.left);
  fits.right.gain = dc_gain(model.linear_part.right);
  fits.left.gain_standard_error.from_left = left.gain_standard_error();
  fits.right.gain_standard_error.from_right = right.gain_standard_error();
  return fits;
}

}  // namespace wheelwright
