#include "model/gap/figures/free_run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <vector>

#include "model/gap/data_checks/encoder_dropout.hpp"
#include "model/gap/figures/visible_error.hpp"
#include "model/gap/noise/steadiness.hpp"
#include "model/prediction/free_run.hpp"
#include "model/prediction/open_loop_runs.hpp"
#include "model/prediction/segments.hpp"

namespace wheelwright::gap {
namespace {

constexpr int draws = 3;

// Noise of one channel, reading by reading.
class Drift {
 public:
  Drift(const TravelNoise& noise, std::mt19937_64& random) : noise_(noise), random_(random) {
    if (lasts()) speed_ = std::sqrt(drift_speed_variance(noise)) * normal_(random_);
  }
  double walk(double duration_s, double unsteady) {
    const DriftStep step(noise_, duration_s, unsteady);
    const double deviation = std::sqrt(std::max(0.0, step.travel_variance));
    const double chance = normal_(random_);
    at_ = step.kept * at_ + step.carry_s * speed_ + deviation * chance;
    if (lasts()) {
      const double along = deviation > 0.0 ? step.covariance / deviation : 0.0;
      const double beside = std::sqrt(std::max(0.0, step.speed_variance - along * along));
      speed_ = step.decay * speed_ + along * chance + beside * normal_(random_);
    }
    return at_;
  }
  // What a reading errs beyond being rounded to whole steps.
  double reading(double step) {
    const double beyond = noise_.reading * noise_.reading - step * step / 12.0;
    return std::sqrt(std::max(0.0, beyond)) * normal_(random_);
  }
  double at() const { return at_; }

 private:
  bool lasts() const { return noise_.drift_correlation_time_s > 0.0; }

  TravelNoise noise_;
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_;
  double at_ = 0.0;
  double speed_ = 0.0;
};

// What readings of a tracker err, by themselves and alike.
class Tracker {
 public:
  Tracker(const TravelNoise& noise, std::mt19937_64& random) : noise_(noise), random_(random) {
    if (noise_.tracker > 0.0) alike_ = noise_.tracker * normal_(random_);
  }
  void go_on(double duration_s) {
    if (noise_.tracker <= 0.0) return;
    const double kept = noise_.tracker_kept(duration_s);
    alike_ = kept * alike_ + noise_.tracker * std::sqrt(1.0 - kept * kept) * normal_(random_);
  }
  double error() { return alike_ + noise_.reading * normal_(random_); }

 private:
  TravelNoise noise_;
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_;
  double alike_ = 0.0;
};

const TravelNoise& of(const NoiseModel& noise, Channel channel) {
  return noise.channel[static_cast<std::size_t>(channel)];
}

// One for each row, by the commands.
std::vector<double> unsteady_rows(const DriveLog& log) {
  std::vector<WheelPair> commands_m_s;
  for (const DriveSample& sample : log.samples) commands_m_s.push_back(sample.command_m_s);
  const double duration_s = log.samples.back().t_s - log.samples.front().t_s;
  return unsteady_periods(commands_m_s, duration_s / static_cast<double>(log.samples.size() - 1));
}

// How far from the middle of a count a run begins, in counts: nobody knows, and at worst it is its edge, as
// of a simulation that counts whole steps from 0. Of counts that are finer than what is visible it does not
// matter.
double start_within_count(double tick_m, std::mt19937_64& random) {
  const double edge = std::nextafter(0.5, 0.0);  // the first count stays 0
  if (tick_m < visible_travel_m) return 0.0;
  return std::bernoulli_distribution(0.5)(random) ? edge : -edge;
}

// A log in which the model's own motion, with noise, stands in the place of what was measured.
DriveLog with_noise(const std::vector<PredictedMotion>& motion, const DriveLog& log, const NoiseModel& noise,
                    std::mt19937_64& random) {
  DriveLog noisy = log;
  const bool counted = log.has_ticks();
  Drift left(counted ? of(noise, Channel::left) : TravelNoise{0.0, 0.0}, random);
  Drift right(counted ? of(noise, Channel::right) : TravelNoise{0.0, 0.0}, random);
  Drift forward(of(noise, Channel::forward), random);
  Drift turn(of(noise, Channel::turn), random);
  Tracker x(of(noise, Channel::forward), random);
  Tracker y(of(noise, Channel::forward), random);
  Tracker theta(of(noise, Channel::turn), random);
  const std::vector<double> unsteady = unsteady_rows(log);
  Pose pose = motion.front().pose;
  const WheelPair count_m = log.metres_per_tick.value_or(WheelPair{});
  const WheelPair start{start_within_count(count_m.left, random), start_within_count(count_m.right, random)};
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (i > 0) {
      const double duration = motion[i].t_s - motion[i - 1].t_s;
      for (Tracker* tracker : {&x, &y, &theta}) tracker->go_on(duration);
      const Pose step = between(motion[i - 1].pose, motion[i].pose);
      const WheelPair wheels_before{left.at(), right.at()};
      const double forward_before = forward.at();
      const double turn_before = turn.at();
      const double slipped_left = left.walk(duration, unsteady[i - 1]) - wheels_before.left;
      const double slipped_right = right.walk(duration, unsteady[i - 1]) - wheels_before.right;
      const double along = step.x_m + 0.5 * (slipped_left + slipped_right) +
                           forward.walk(duration, unsteady[i - 1]) - forward_before;
      const double turned = step.theta_rad + (slipped_right - slipped_left) / log.wheel_base_m +
                            turn.walk(duration, unsteady[i - 1]) - turn_before;
      const double middle = pose.theta_rad + 0.5 * turned;
      pose = {pose.x_m + along * std::cos(middle) - step.y_m * std::sin(middle),
              pose.y_m + along * std::sin(middle) + step.y_m * std::cos(middle), pose.theta_rad + turned};
    }
    DriveSample& sample = noisy.samples[i];
    if (sample.ticks) {
      const WheelPair& tick = *log.metres_per_tick;
      sample.ticks->left = std::llround(
          (motion[i].distance_m.left + left.at() + left.reading(tick.left)) / tick.left + start.left);
      sample.ticks->right = std::llround(
          (motion[i].distance_m.right + right.at() + right.reading(tick.right)) / tick.right + start.right);
    }
    if (sample.reference_x_m) sample.reference_x_m = pose.x_m + x.error();
    if (sample.reference_y_m) sample.reference_y_m = pose.y_m + y.error();
    if (sample.reference_theta_rad) sample.reference_theta_rad = pose.theta_rad + theta.error();
  }
  return noisy;
}

}  // namespace

Score gap_size(const RobotModel& model, std::span<const DriveLog> logs) {
  ScoreSums sums;
  for (const auto& log : logs) add_open_loop(model, log, sums);
  return sums.score();
}

Score gap_size_with_lost_counts(const RobotModel& model, std::span<const DriveLog> logs) {
  std::vector<DriveLog> as_counted;
  std::ranges::transform(logs, std::back_inserter(as_counted), with_lost_counts);
  return gap_size(model, as_counted);
}

Score noise_floor(const RobotModel& model, std::span<const DriveLog> logs, const NoiseModel& noise,
                  std::uint64_t seed) {
  std::mt19937_64 random(seed);
  ScoreSums sums;
  for (const auto& log : logs) {
    const auto motion = free_run(model, log);
    for (int draw = 0; draw < draws; ++draw) {
      add_segments(motion, with_noise(motion, log, noise, random), log.period_s, sums);
    }
  }
  return sums.score();
}

NoiseModel with_slow_noise(const FitProblem& problem, const TrialModel& model, double max_apart_s) {
  NoiseModel noise = problem.noise();
  for (const double far_apart_s : {half_a_second_apart_s, two_seconds_apart_s}) {
    if (far_apart_s > max_apart_s) continue;
    const NoiseModel slow = problem.noise_left_by(model, far_apart_s, no_correlation_time_s);
    for (std::size_t c = 0; c < channel_count; ++c) {
      if (slow.channel[c].walk_per_sqrt_s <= noise.channel[c].walk_per_sqrt_s) continue;
      noise.channel[c].walk_per_sqrt_s = slow.channel[c].walk_per_sqrt_s;
      noise.channel[c].return_time_s = slow.channel[c].return_time_s;
    }
  }
  return noise;
}

}  // namespace wheelwright::gap
