// Compares candidates for a model, on the runs that they were fitted to and on runs that were held out.
//
// A candidate's score is its gain of log-likelihood on both, each divided by the autocorrelation factor f of
// its residuals, less the penalty of its parameters (BIC); p: parameters, n: readings of all runs.
//
//   score = train_nats / f_train + heldout_nats / f_heldout - p / 2 ln n
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// One effect that was tried beside others, fitted jointly with the linear part.
struct Candidate {
  TrialEffect effect;
  double train_nats = 0.0;    // gain of log likelihood over the model without it
  double heldout_nats = 0.0;  // the same on the held-out runs, with nothing fitted there
  // Where held-out runs do not decide: the same on each training run, fitted to the others. Else 0.
  double left_out_nats = 0.0;
  // By which correlation of the residuals makes these gains look too large: of the training runs, and of the
  // held-out ones.
  double train_autocorrelation_factor = 1.0;
  double heldout_autocorrelation_factor = 1.0;
  double score = 0.0;  // both gains, deflated, less the price of the parameters, beside the best one's
  Fit fit;
  std::size_t behind = 0;  // so many of the fit's effects act behind it
  std::vector<double> heldout_residuals;

  // On runs that it was not fitted to.
  double unseen_nats() const { return heldout_nats + left_out_nats; }

  // The same gains, deflated.
  double deflated_train_nats() const { return train_nats / train_autocorrelation_factor; }
  double deflated_heldout_nats() const { return heldout_nats / heldout_autocorrelation_factor; }
  double deflated_unseen_nats() const {
    return deflated_heldout_nats() + left_out_nats / train_autocorrelation_factor;
  }
  double autocorrelation_factor() const {
    return std::max(train_autocorrelation_factor, heldout_autocorrelation_factor);
  }
};

// A delay that no usual linear part could hold, together with that of the model's own, is more than another
// shape of one.
bool beyond_a_linear_part(const TrialModel& model, const TrialEffect& effect);

// What could be added to a model, best first.
struct SelectionStep {
  Fit without;
  double heldout_sum_squares = 0.0;  // of `without`
  std::vector<Candidate> candidates;
  std::optional<Fit> pair;  // with two more effects that explain together what no single one does
};

struct SearchLimits {
  std::size_t max_effects = 4;
  std::size_t max_fits = 9;       // per round
  double min_heldout_nats = 9.0;  // deflated; the chance of a false one is at most exp(-9) each
  double min_train_nats = 9.0;
  double clear_train_nats = 30.0;     // training leaves no doubt which effect held-out runs have to confirm,
  double confirming_nats = 6.0;       // and this confirms it
  std::size_t max_poles = 5;          // of the linear part
  double min_linear_part_nats = 3.0;  // held out, deflated, for a larger linear part
  double min_further_nats = 20.0;     // held out, deflated, for a further effect
  double min_share = 0.06;            // of what the strongest effect explains, for a further one
  double min_share_before_noise = 0.003;  // the same for one that leaves nothing but noise
  double min_idle_nats = 40.0;            // held out, deflated, for one that free runs do not show
  double clear_delay_nats = 100.0;        // the same for a delay that no linear part could hold
  double clear_left_out_nats =
      100.0;                    // of training runs by each other, for one that held-out runs do not show
  std::size_t max_paths = 3;    // first effects from each of which a search goes on
  double min_path_score = 0.4;  // of the best one's, for a path of its own
};

class ModelComparison {
 public:
  ModelComparison(const FitProblem& train, const FitProblem& heldout, const SearchLimits& limits);

  // Whether the wheels of each run began at angles of their own: that is paid for.
  void set_angles_differ(bool differ) { angles_differ_ = differ; }

  // Judges the fits of all candidates against the model without them, and puts the best first. Those whose
  // effect came out of no consequence are gone.
  void judge(SelectionStep& selection_step) const;

  // Whether a richer linear part that was fitted to the same runs is worth its parameters; nothing or less if
  // not.
  double core_score(const SelectionStep& selection_step, const Fit& richer) const;

  // By how much one whole model is better than another, in deflated nats less the price of the parameters.
  // Both must have been fitted under the present noise.
  double advantage(const Fit& one, const Fit& other) const;

  // The price of all its parameters, in nats (BIC).
  double complexity_penalty(const TrialModel& model) const;

  bool good_enough(const Candidate& candidate) const;
  // Good enough for a further effect, small as it may be beside the first.
  bool clear(const Candidate& candidate) const;
  // A second effect that explains next to nothing beside the first is more often the first one's shape than
  // an effect, where both show in the same readings.
  bool worth_adding(const Candidate& candidate, std::span<const SelectionStep> so_far) const;
  // Whether the last effect of `both`, beside the other one that is in both, still gains what it takes to be
  // named. A decoy that explains more does not speak against a name that does: it explains something else.
  bool stands_beside(const Fit& both, const Candidate& other) const;
  // Whether one candidate gains about as much beside another as alone: then they are no rivals. `both` has
  // the two of them.
  bool explains_something_else(const Fit& both, const Candidate& one, const Candidate& other) const;
  // Whether two effects at once are worth it: against the model without them, and against the best single
  // one.
  bool pair_worth_adding(const Fit& pair, const SelectionStep& selection_step) const;

 private:
  Candidate judged(const Fit& without, const std::vector<double>& heldout_without, Candidate candidate) const;
  bool undecided_by_held_out_runs(const Candidate& candidate, bool is_further) const;
  bool acts_in_held_out_runs(const Candidate& candidate) const;
  bool acts_linearly(const Candidate& candidate) const;
  double autocorrelation_factor_between(const Candidate& worse, const Candidate& better) const;
  void rank(std::vector<Candidate>& candidates) const;
  static void leave_out_aliases(std::vector<Candidate>& candidates);
  double score_alone(const Candidate& candidate) const;
  bool clearly_better(const Fit& with, const Fit& without) const;
  double complexity_penalty(const TrialEffect& effect) const;
  double penalty_per_parameter() const;

  const FitProblem& train_;
  const FitProblem& heldout_;
  SearchLimits limits_;
  double largest_command_m_s_ = 0.0;
  bool angles_differ_ = false;
};

}  // namespace wheelwright::gap
