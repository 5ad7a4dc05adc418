// A least-squares problem: runs, the noise of their readings, and the fit of a whole model to them, linear
// part and effects together. Residuals are free-run errors divided by what noise makes of them
// (whitening.hpp), and have no unit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "model/gap/fit/free_run_errors.hpp"
#include "model/gap/fit/parallel_for.hpp"
#include "model/gap/fit/trial_model.hpp"
#include "model/gap/noise/noise_fit.hpp"
#include "model/gap/noise/whitening.hpp"
#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

// Noise of each channel, and of a segment between far references.
struct NoiseModel {
  std::array<TravelNoise, channel_count> channel;
  double segment = 1.0;  // by which the usual noise of a segment is multiplied
};

double sum_squares_of(const std::vector<double>& values);

struct Fit {
  TrialModel model;
  double sum_squares =
      0.0;  // of innovations: minus twice the log likelihood, but for what hangs on the noise alone
  std::vector<double> residuals;
};

class FitProblem {
 public:
  // The runs must be made with one period and wheel base.
  FitProblem(std::vector<GapRun> runs, std::vector<WheelPair> metres_per_tick, ParallelFor parallel_for);

  const std::vector<GapRun>& runs() const { return runs_; }
  // Of a run; zero without counts.
  const WheelPair& metres_per_tick(std::size_t run) const { return metres_per_tick_[run]; }
  bool has_counts() const;
  std::size_t readings() const { return size_; }

  // The noise under which the errors of a model are most likely. Only readings that lie at least
  // `min_apart_s` apart are used.
  NoiseModel noise_left_by(const TrialModel& model, double min_apart_s = 0.0,
                           double max_correlation_time_s = motor_correlation_time_s) const;
  void set_noise(const NoiseModel& noise);
  const NoiseModel& noise() const { return noise_; }

  // The outputs that a parameter of this stage affects; all where some run has no counts.
  Outputs outputs_of(EffectStage stage) const;
  Outputs outputs_of(const TrialEffect& effect) const;
  bool is_among(std::size_t residual, Outputs outputs) const;
  // Whether some run has no counts, which ties wheels and motion together: then every parameter affects all.
  bool outputs_are_tied() const { return outputs_are_tied_; }

  // Innovations of all channels of all runs, one after the other; zero for other outputs.
  std::vector<double> residuals(const TrialModel& model, Outputs outputs = Outputs::all) const;
  // Of the runs under the present noise, but for a constant: by the innovations of all channels and what the
  // noise itself makes likely. Models under noises of their own are compared by it.
  double log_likelihood(const std::vector<double>& residuals) const;
  // Innovations of errors that are there already, one set for each run.
  std::vector<double> residuals(std::span<const RunErrors> errors) const;
  // What one residual belongs to.
  struct ResidualIndex {
    std::size_t run;
    std::optional<Channel> channel;  // nothing for a segment
    std::size_t reading;
    std::size_t period;  // grid time
  };
  const std::vector<ResidualIndex>& indices() const { return indices_; }

  // What errors in one channel of a run come to among the residuals, and where they stand there; nothing for
  // a channel that the run does not have.
  struct Innovations {
    std::size_t first_residual = 0;
    std::vector<double> values;
  };
  std::optional<Innovations> innovations(std::size_t run, Channel channel,
                                         std::span<const double> errors) const;

  // The least that a reading of a channel can err, m or rad: of counts, by rounding.
  double smallest_reading(std::size_t channel) const;

  // Sets where the wheels of each run stood at its start.
  void set_initial_travel(std::span<const WheelPair> rolled_m);

  // One column per parameter, of the residuals; zero for parameters that do not affect the outputs.
  Eigen::MatrixXd jacobian(const TrialModel& model, const std::vector<double>& residuals,
                           Outputs outputs = Outputs::all) const;

  // Levenberg-Marquardt from `start`, over the parameters that affect the outputs. Stops early where nothing
  // is gained.
  Fit fit(const TrialModel& start, int max_steps, Outputs outputs = Outputs::all) const;
  // The same over all outputs, with parameters held where they are; one flag for each.
  Fit fit_with_held(const TrialModel& start, int max_steps, const std::vector<char>& is_held) const;

 private:
  struct Block {  // one channel of one run in the vector of residuals
    std::size_t run;
    std::size_t channel;
    std::size_t offset;
    std::vector<double> times_s;
    std::vector<double> unsteady;  // share of the time since the reading before
  };
  struct SegmentBlock {
    std::size_t run;
    std::size_t segment;
    std::size_t offset;
    Eigen::Matrix3d whitening;
  };

  // A parameter that is moved to see what follows; `shows_in` where it can show in one channel only.
  struct Moved {
    std::size_t parameter;
    std::optional<Channel> shows_in;
  };
  using MovedAtOnce = std::vector<Moved>;

  std::vector<double> whitened(std::size_t run, const RunErrors& errors) const;
  void fill_columns(const TrialModel& model, const std::vector<double>& residuals, const MovedAtOnce& at_once,
                    std::size_t run, Outputs touched, Eigen::MatrixXd& columns) const;
  bool shows_only_in(const Eigen::MatrixXd& columns, std::size_t column, Channel channel) const;
  static bool is_of(Outputs outputs, const std::optional<Channel>& channel);
  Outputs outputs_of_parameter(const TrialModel& model, std::size_t parameter) const;
  Outputs outputs_shown_by(const TrialModel& model, std::size_t parameter) const;

  std::vector<GapRun> runs_;
  std::vector<WheelPair> metres_per_tick_;  // of each run; zero without counts
  ParallelFor parallel_for_;
  NoiseModel noise_;
  std::vector<Block> blocks_;
  std::vector<SegmentBlock> segments_;
  std::vector<Whitener> whiteners_;                             // one per block
  std::vector<std::pair<std::size_t, std::size_t>> run_range_;  // of each run in the vector of residuals
  std::vector<ResidualIndex> indices_;
  std::size_t size_ = 0;
  bool outputs_are_tied_ = false;  // a run without counts ties wheels and motion together
};

}  // namespace wheelwright::gap
