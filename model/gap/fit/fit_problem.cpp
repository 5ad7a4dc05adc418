#include "model/gap/fit/fit_problem.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/gap/noise/segment_noise.hpp"
#include "model/gap/noise/steadiness.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_segment = 0.3;
constexpr double max_default_segment = 1.5;
constexpr double enough_segment_readings = 100.0;

}  // namespace

double sum_squares_of(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

FitProblem::FitProblem(std::vector<GapRun> runs, std::vector<WheelPair> metres_per_tick,
                       ParallelFor parallel_for)
    : runs_(std::move(runs)),
      metres_per_tick_(std::move(metres_per_tick)),
      parallel_for_(std::move(parallel_for)) {
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const GapRun& run = runs_[r];
    const std::size_t begin = size_;
    const std::vector<double> unsteady = unsteady_periods(run.commands_m_s, run.period_s);
    for (std::size_t c = 0; c < channel_count; ++c) {
      const Series& series = run.series[c];
      if (series.empty()) continue;
      Block block{r, c, size_, {}, {}};
      for (std::size_t i = 0; i < series.at.size(); ++i) {
        block.times_s.push_back(run.period_s *
                                (static_cast<double>(series.at[i].period) + series.at[i].share));
        indices_.push_back({r, static_cast<Channel>(c), i, series.at[i].period});
      }
      block.unsteady = unsteady_shares(unsteady, block.times_s, run.period_s);
      size_ += series.at.size();
      blocks_.push_back(std::move(block));
    }
    if (run.sparse) {
      for (std::size_t i = 1; i < run.references.size(); ++i) {
        if (run.references[i].counts_lost) continue;
        segments_.push_back({r, i - 1, size_, Eigen::Matrix3d::Identity()});
        for (std::size_t component = 0; component < 3; ++component) {
          indices_.push_back({r, std::nullopt, i, run.references[i].at.period});
        }
        size_ += 3;
      }
    }
    run_range_.emplace_back(begin, size_);
    if (!run.has_counts) outputs_are_tied_ = true;
  }
  set_noise({});
}

bool FitProblem::has_counts() const {
  return std::ranges::any_of(runs_, [](const GapRun& run) { return run.has_counts; });
}

double FitProblem::smallest_reading(std::size_t channel) const {
  if (channel > static_cast<std::size_t>(Channel::right)) return 1e-5;
  double largest_tick = 0.0;
  for (const auto& tick : metres_per_tick_) largest_tick = std::max({largest_tick, tick.left, tick.right});
  return std::max(largest_tick / std::sqrt(12.0), 1e-6);
}

NoiseModel FitProblem::noise_left_by(const TrialModel& model, double min_apart_s,
                                     double max_correlation_time_s) const {
  std::vector<RunErrors> errors(runs_.size());
  parallel_for_(runs_.size(), [&](std::size_t r) { errors[r] = free_run_errors(model, runs_[r]); });
  NoiseModel noise = noise_;
  parallel_for_(channel_count, [&](std::size_t c) {
    std::vector<ErrorSeries> series;
    for (const auto& block : blocks_) {
      if (block.channel != c) continue;
      series.push_back(thinned(
          {block.times_s, runs_[block.run].series[c].restarts, errors[block.run].series[c], block.unsteady},
          min_apart_s));
    }
    std::vector<NoiseSample> samples;
    samples.reserve(series.size());
    for (const auto& one : series) samples.push_back(one.sample());
    const bool of_references =
        c > static_cast<std::size_t>(Channel::right) && max_correlation_time_s > no_correlation_time_s;
    if (!samples.empty())
      noise.channel[c] = noise_of(samples, {smallest_reading(c), max_correlation_time_s, of_references});
  });
  // Both wheels are of one make: what one shows of noise holds for the other.
  if (!segments_.empty()) {
    double sum_squares = 0.0;
    double count = 0.0;
    for (const GapRun& run : runs_) {
      if (!run.sparse || !run.reference_noise) continue;
      noise.channel[static_cast<std::size_t>(Channel::forward)].reading = run.reference_noise->position_m;
      noise.channel[static_cast<std::size_t>(Channel::turn)].reading = run.reference_noise->heading_rad;
    }
    for (const auto& block : segments_) {
      count += runs_[block.run].heading_alone ? 1.0 : 3.0;
      const SegmentError& e = errors[block.run].segments[block.segment];
      const Eigen::LLT<Eigen::Matrix3d> factor(default_segment_covariance(runs_[block.run], block.segment));
      sum_squares += factor.matrixL().solve(Eigen::Vector3d(e.x_m, e.y_m, e.theta_rad)).squaredNorm();
    }
    // A handful of poses cannot tell noise from what is missing: then no more is believed than robots usually
    // drift.
    const double most =
        count < enough_segment_readings ? max_default_segment : std::numeric_limits<double>::infinity();
    noise.segment = std::clamp(std::sqrt(sum_squares / count), min_segment, most);
  }
  return noise;
}

void FitProblem::set_noise(const NoiseModel& noise) {
  noise_ = noise;
  whiteners_.clear();
  for (const auto& block : blocks_) {
    whiteners_.emplace_back(block.times_s, runs_[block.run].series[block.channel].restarts,
                            noise.channel[block.channel], block.unsteady);
  }
  for (auto& block : segments_) {
    const Eigen::Matrix3d covariance =
        noise.segment * noise.segment * default_segment_covariance(runs_[block.run], block.segment);
    const Eigen::LLT<Eigen::Matrix3d> factor(covariance);
    block.whitening = factor.matrixL().solve(Eigen::Matrix3d::Identity());
  }
}

double FitProblem::log_likelihood(const std::vector<double>& residuals) const {
  double log_determinant = 0.0;
  for (const Whitener& whitener : whiteners_) log_determinant += whitener.log_determinant();
  for (const auto& block : segments_) log_determinant -= block.whitening.diagonal().array().log().sum();
  return -0.5 * sum_squares_of(residuals) - log_determinant;
}

Outputs FitProblem::outputs_of(EffectStage stage) const {
  if (outputs_are_tied_) return Outputs::all;
  return stage == EffectStage::command || stage == EffectStage::wheel ? Outputs::wheels : Outputs::motion;
}

Outputs FitProblem::outputs_of(const TrialEffect& effect) const {
  return outputs_of(effect.info->variants[effect.variant].stage);
}

// The motion beyond odometry is what an effect makes of the wheels' motion: with none, it is zero however
// they move; with one, poses show how the wheels move, too.
Outputs FitProblem::outputs_shown_by(const TrialModel& model, std::size_t parameter) const {
  const Outputs own = outputs_of_parameter(model, parameter);
  const bool beyond_odometry = std::ranges::any_of(
      model.effects, [&](const TrialEffect& effect) { return outputs_of(effect) == Outputs::motion; });
  return own == Outputs::wheels && beyond_odometry ? Outputs::all : own;
}

Outputs FitProblem::outputs_of_parameter(const TrialModel& model, std::size_t parameter) const {
  if (parameter < model.shape.of_wheels()) return outputs_of(EffectStage::command);
  if (parameter < model.linear_part.size()) return outputs_of(EffectStage::observation);
  parameter -= model.linear_part.size();
  for (const auto& effect : model.effects) {
    if (parameter < effect.parameters.size()) return outputs_of(effect);
    parameter -= effect.parameters.size();
  }
  return Outputs::all;
}

bool FitProblem::is_among(std::size_t residual, Outputs outputs) const {
  return is_of(outputs, indices_[residual].channel);
}

bool FitProblem::is_of(Outputs outputs, const std::optional<Channel>& channel) {
  if (outputs == Outputs::all) return true;
  const bool of_wheels = channel == Channel::left || channel == Channel::right;
  return of_wheels == (outputs == Outputs::wheels);
}

std::vector<double> FitProblem::whitened(std::size_t run, const RunErrors& errors) const {
  const auto [begin, end] = run_range_[run];
  std::vector<double> residuals(end - begin, 0.0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto& series = errors.series[blocks_[b].channel];
    if (blocks_[b].run != run || series.empty()) continue;
    whiteners_[b].apply(series, residuals.data() + (blocks_[b].offset - begin));
  }
  for (const auto& block : segments_) {
    if (block.run != run || errors.segments.empty()) continue;
    const SegmentError& e = errors.segments[block.segment];
    const Eigen::Vector3d white = block.whitening * Eigen::Vector3d(e.x_m, e.y_m, e.theta_rad);
    for (std::size_t i = 0; i < 3; ++i)
      residuals[block.offset - begin + i] = white(static_cast<Eigen::Index>(i));
  }
  return residuals;
}

std::vector<double> FitProblem::residuals(const TrialModel& model, Outputs outputs) const {
  std::vector<double> all(size_, 0.0);
  parallel_for_(runs_.size(), [&](std::size_t run) {
    std::ranges::copy(whitened(run, free_run_errors(model, runs_[run], outputs)),
                      all.begin() + static_cast<std::ptrdiff_t>(run_range_[run].first));
  });
  return all;
}

std::vector<double> FitProblem::residuals(std::span<const RunErrors> errors) const {
  std::vector<double> all(size_, 0.0);
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    std::ranges::copy(whitened(run, errors[run]),
                      all.begin() + static_cast<std::ptrdiff_t>(run_range_[run].first));
  }
  return all;
}

std::optional<FitProblem::Innovations> FitProblem::innovations(std::size_t run, Channel channel,
                                                               std::span<const double> errors) const {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].run != run || blocks_[b].channel != static_cast<std::size_t>(channel)) continue;
    Innovations result{blocks_[b].offset, std::vector<double>(errors.size())};
    whiteners_[b].apply(errors, result.values.data());
    return result;
  }
  return std::nullopt;
}

void FitProblem::set_initial_travel(std::span<const WheelPair> rolled_m) {
  for (std::size_t r = 0; r < runs_.size(); ++r) runs_[r].initial_travel_m = rolled_m[r];
}

}  // namespace wheelwright::gap
