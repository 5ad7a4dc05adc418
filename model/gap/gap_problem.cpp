#include "model/gap/gap_problem.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wheelwright::gap {
namespace {

// What wandering and reading noise a stretch between far references has before the data say better.
constexpr double stretch_walk_m_per_sqrt_s = 1e-3;
constexpr double stretch_walk_rad_per_sqrt_s = 2e-3;
constexpr double stretch_reading_m = 1e-3;
constexpr double stretch_reading_rad = 2e-3;
constexpr double least_stretch = 0.3;
constexpr double most_usual_stretch = 1.5;
constexpr double enough_stretch_readings = 100.0;

double step_for(const TrialModel& model, std::size_t index) {
  const ParameterInfo* info = model.parameter_info(index);
  const double value = model.parameter(index);
  if (info == nullptr) return 1e-5;
  double smallest = 0.0;
  for (const double size : info->sizes) {
    if (size != 0.0 && (smallest == 0.0 || std::abs(size) < smallest)) smallest = std::abs(size);
  }
  if (smallest == 0.0) smallest = 0.1;
  const double step = std::max(0.01 * std::abs(value), 0.02 * smallest);
  return value + step > info->upper ? -step : step;
}

double damping_floor(const Eigen::MatrixXd& information, Eigen::Index i) {
  return information(i, i) > 0.0 ? information(i, i) : 1.0;
}

TrialModel moved(const TrialModel& model, const Eigen::VectorXd& step) {
  TrialModel result = model;
  for (std::size_t i = 0; i < model.parameter_count(); ++i) {
    result.set_parameter(i, model.parameter(i) + step(static_cast<Eigen::Index>(i)));
  }
  return result;
}

}  // namespace

double squares_of(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

void for_each_in_turn(std::size_t count, const std::function<void(std::size_t)>& job) {
  for (std::size_t i = 0; i < count; ++i) job(i);
}

GapProblem::GapProblem(std::vector<GapRun> runs, std::vector<WheelPair> metres_per_tick, ForEach for_each)
    : runs_(std::move(runs)), metres_per_tick_(std::move(metres_per_tick)), for_each_(std::move(for_each)) {
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const GapRun& run = runs_[r];
    const std::size_t begin = size_;
    for (std::size_t c = 0; c < channel_count; ++c) {
      const Series& series = run.series[c];
      if (series.empty()) continue;
      Block block{r, c, size_, {}};
      for (std::size_t i = 0; i < series.at.size(); ++i) {
        block.times_s.push_back(run.period_s *
                                (static_cast<double>(series.at[i].period) + series.at[i].share));
        places_.push_back({r, static_cast<Channel>(c), i, series.at[i].period});
      }
      size_ += series.at.size();
      blocks_.push_back(std::move(block));
    }
    if (run.sparse) {
      for (std::size_t i = 1; i < run.references.size(); ++i) {
        stretches_.push_back({r, i - 1, size_, Eigen::Matrix3d::Identity()});
        for (std::size_t part = 0; part < 3; ++part) {
          places_.push_back({r, std::nullopt, i, run.references[i].at.period});
        }
        size_ += 3;
      }
    }
    run_range_.emplace_back(begin, size_);
    if (!run.has_counts) parts_touch_ = true;
  }
  set_noise({});
}

bool GapProblem::has_counts() const {
  return std::ranges::any_of(runs_, [](const GapRun& run) { return run.has_counts; });
}

bool GapProblem::has_motion() const {
  return std::ranges::any_of(runs_, [](const GapRun& run) { return run.references.size() >= 2; });
}

double GapProblem::smallest_reading(std::size_t channel) const {
  if (channel > static_cast<std::size_t>(Channel::right)) return 1e-5;
  double largest_tick = 0.0;
  for (const auto& tick : metres_per_tick_) largest_tick = std::max({largest_tick, tick.left, tick.right});
  return std::max(largest_tick / std::sqrt(12.0), 1e-6);
}

NoiseModel GapProblem::noise_left_by(const TrialModel& model) const {
  std::vector<RunErrors> errors(runs_.size());
  for_each_(runs_.size(), [&](std::size_t r) { errors[r] = free_run_errors(model, runs_[r]); });
  NoiseModel noise = noise_;
  for (std::size_t c = 0; c < channel_count; ++c) {
    std::vector<NoiseSample> samples;
    for (const auto& block : blocks_) {
      if (block.channel != c) continue;
      samples.push_back({block.times_s, runs_[block.run].series[c].restarts, errors[block.run].series[c]});
    }
    if (!samples.empty()) noise.channel[c] = noise_of(samples, smallest_reading(c));
  }
  // Both wheels are of one make: what one shows of noise holds for the other.
  if (!stretches_.empty()) {
    double squares = 0.0;
    for (const auto& block : stretches_) {
      const StretchError& e = errors[block.run].stretches[block.stretch];
      const Eigen::LLT<Eigen::Matrix3d> factor(stretch_covariance(runs_[block.run], block.stretch));
      squares += factor.matrixL().solve(Eigen::Vector3d(e.x_m, e.y_m, e.theta_rad)).squaredNorm();
    }
    const double count = 3.0 * static_cast<double>(stretches_.size());
    // A handful of poses cannot tell noise from what is missing: then no more is believed than robots usually
    // wander.
    const double most =
        count < enough_stretch_readings ? most_usual_stretch : std::numeric_limits<double>::infinity();
    noise.stretch = std::clamp(std::sqrt(squares / count), least_stretch, most);
  }
  return noise;
}

void GapProblem::set_noise(const NoiseModel& noise) {
  noise_ = noise;
  whiteners_.clear();
  for (const auto& block : blocks_) {
    whiteners_.emplace_back(block.times_s, runs_[block.run].series[block.channel].restarts,
                            noise.channel[block.channel]);
  }
  for (auto& block : stretches_) {
    const Eigen::Matrix3d covariance =
        noise.stretch * noise.stretch * stretch_covariance(runs_[block.run], block.stretch);
    const Eigen::LLT<Eigen::Matrix3d> factor(covariance);
    block.whitening = factor.matrixL().solve(Eigen::Matrix3d::Identity());
  }
}

// Wandering in distance and heading, carried to the end of the stretch along the path that odometry shows
// (without counts: along the straight line between the references), and the readings' own noise.
Eigen::Matrix3d GapProblem::stretch_covariance(const GapRun& run, std::size_t stretch) const {
  const Reference& from = run.references[stretch];
  const Reference& to = run.references[stretch + 1];
  const std::size_t first = from.at.period;
  const std::size_t last = std::max(to.at.period, first + 1);
  std::vector<Pose> path{Pose{}};
  const Pose end = relative_to(from.pose, to.pose);
  for (std::size_t k = first; k < last; ++k) {
    const double share = 1.0 / static_cast<double>(last - first);
    path.push_back(
        run.has_counts && k < run.odometry.size()
            ? move_along_arc(path.back(), {run.odometry[k].forward_m, run.odometry[k].turn_rad}, 1.0)
            : Pose{path.back().x_m + share * end.x_m, path.back().y_m + share * end.y_m,
                   path.back().theta_rad + share * end.theta_rad});
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const auto lever = [&](const Pose& at) {
    return Eigen::Vector3d(-(path.back().y_m - at.y_m), path.back().x_m - at.x_m, 1.0);
  };
  for (const Pose& at : path) {
    const Eigen::Vector3d along(std::cos(at.theta_rad), std::sin(at.theta_rad), 0.0);
    covariance +=
        run.period_s * stretch_walk_m_per_sqrt_s * stretch_walk_m_per_sqrt_s * along * along.transpose();
    covariance += run.period_s * stretch_walk_rad_per_sqrt_s * stretch_walk_rad_per_sqrt_s * lever(at) *
                  lever(at).transpose();
  }
  const Eigen::Vector3d start = lever(path.front());
  covariance += stretch_reading_rad * stretch_reading_rad * start * start.transpose();
  covariance +=
      Eigen::Vector3d(2.0 * stretch_reading_m * stretch_reading_m,
                      2.0 * stretch_reading_m * stretch_reading_m, stretch_reading_rad * stretch_reading_rad)
          .asDiagonal();
  return covariance;
}

Part GapProblem::part_of(EffectStage stage) const {
  if (parts_touch_) return Part::all;
  return stage == EffectStage::command || stage == EffectStage::wheel ? Part::wheels : Part::motion;
}

Part GapProblem::part_of(const TrialEffect& effect) const {
  return part_of(effect.info->variants[effect.variant].stage);
}

Part GapProblem::part_of_parameter(const TrialModel& model, std::size_t parameter) const {
  if (parameter < model.shape.of_wheels()) return part_of(EffectStage::command);
  if (parameter < model.core.size()) return part_of(EffectStage::observation);
  parameter -= model.core.size();
  for (const auto& effect : model.effects) {
    if (parameter < effect.parameters.size()) return part_of(effect);
    parameter -= effect.parameters.size();
  }
  return Part::all;
}

bool GapProblem::in_part(std::size_t residual, Part part) const {
  if (part == Part::all) return true;
  const auto& channel = places_[residual].channel;
  const bool of_wheels = channel == Channel::left || channel == Channel::right;
  return of_wheels == (part == Part::wheels);
}

std::vector<double> GapProblem::residuals_of(std::size_t run, const TrialModel& model, Part part) const {
  const auto [begin, end] = run_range_[run];
  std::vector<double> residuals(end - begin, 0.0);
  const RunErrors errors = free_run_errors(model, runs_[run], part);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto& series = errors.series[blocks_[b].channel];
    if (blocks_[b].run != run || series.empty()) continue;
    whiteners_[b].apply(series, residuals.data() + (blocks_[b].offset - begin));
  }
  for (const auto& block : stretches_) {
    if (block.run != run || errors.stretches.empty()) continue;
    const StretchError& e = errors.stretches[block.stretch];
    const Eigen::Vector3d white = block.whitening * Eigen::Vector3d(e.x_m, e.y_m, e.theta_rad);
    for (std::size_t i = 0; i < 3; ++i)
      residuals[block.offset - begin + i] = white(static_cast<Eigen::Index>(i));
  }
  return residuals;
}

std::vector<double> GapProblem::residuals(const TrialModel& model, Part part) const {
  std::vector<double> all(size_, 0.0);
  for_each_(runs_.size(), [&](std::size_t run) {
    std::ranges::copy(residuals_of(run, model, part),
                      all.begin() + static_cast<std::ptrdiff_t>(run_range_[run].first));
  });
  return all;
}

std::optional<GapProblem::Innovations> GapProblem::innovations(std::size_t run, Channel channel,
                                                               std::span<const double> errors) const {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].run != run || blocks_[b].channel != static_cast<std::size_t>(channel)) continue;
    Innovations result{blocks_[b].offset, std::vector<double>(errors.size())};
    whiteners_[b].apply(errors, result.values.data());
    return result;
  }
  return std::nullopt;
}

void GapProblem::set_rolled_before(std::span<const WheelPair> rolled_m) {
  for (std::size_t r = 0; r < runs_.size(); ++r) runs_[r].rolled_before_m = rolled_m[r];
}

Eigen::MatrixXd GapProblem::jacobian(const TrialModel& model, const std::vector<double>& residuals,
                                     Part part) const {
  const std::size_t count = model.parameter_count();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(count));
  for_each_(count * runs_.size(), [&](std::size_t job) {
    const std::size_t parameter = job / runs_.size();
    const std::size_t run = job % runs_.size();
    const Part touched = part_of_parameter(model, parameter);
    if (part != Part::all && touched != part) return;
    TrialModel changed = model;
    const double step = step_for(model, parameter);
    changed.set_parameter(parameter, model.parameter(parameter) + step);
    const std::vector<double> there = residuals_of(run, changed, touched);
    const std::size_t begin = run_range_[run].first;
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (!in_part(begin + i, touched)) continue;
      columns(static_cast<Eigen::Index>(begin + i), static_cast<Eigen::Index>(parameter)) =
          (there[i] - residuals[begin + i]) / step;
    }
  });
  return columns;
}

GapFit GapProblem::fit(const TrialModel& start, int most_steps, Part part) const {
  constexpr double worth_a_step = 0.2;  // of the sum of squares: a tenth of a nat
  GapFit best{start, 0.0, residuals(start, part), {}};
  best.squares = squares_of(best.residuals);
  double damping = 1e-3;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::MatrixXd columns = jacobian(best.model, best.residuals, part);
    best.information = columns.transpose() * columns;
    const Eigen::Map<const Eigen::VectorXd> residual(best.residuals.data(),
                                                     static_cast<Eigen::Index>(best.residuals.size()));
    const Eigen::VectorXd gradient = columns.transpose() * residual;
    const double before = best.squares;
    for (int attempt = 0; attempt < 6; ++attempt) {
      Eigen::MatrixXd damped = best.information;
      for (Eigen::Index i = 0; i < damped.rows(); ++i) {
        damped(i, i) += damping * damping_floor(best.information, i);
      }
      const TrialModel candidate = moved(best.model, -damped.ldlt().solve(gradient));
      if (candidate.stable()) {
        std::vector<double> there = residuals(candidate, part);
        const double squares = squares_of(there);
        if (squares < best.squares) {
          best.model = candidate;
          best.residuals = std::move(there);
          best.squares = squares;
          damping = std::max(1e-7, 0.2 * damping);
          break;
        }
      }
      damping *= 8.0;
    }
    if (before - best.squares < worth_a_step + 1e-5 * before) break;
  }
  if (part != Part::all) {
    best.residuals = residuals(best.model);
    best.squares = squares_of(best.residuals);
  }
  return best;
}

}  // namespace wheelwright::gap
