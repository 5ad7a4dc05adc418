// Finds the effects that a linear model of these runs lacks: candidates are screened, fitted together with
// the core, judged on runs that were held out, and put in one after the other, with swaps, since effects mask
// each other.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/gap_problem.hpp"
#include "model/gap/screening.hpp"

namespace wheelwright::gap {

// One effect that was tried beside others, fitted jointly with the core.
struct Contender {
  TrialEffect effect;
  double train_nats = 0.0;    // gain of log likelihood over the model without it
  double heldout_nats = 0.0;  // the same on the held-out runs, with nothing fitted there
  double inflation = 1.0;     // by which correlation of what is left makes these gains look too large
  double score = 0.0;         // both gains, deflated, less the price of the parameters
  GapFit fit;
};

// One look at a model: who could be added to it, best first.
struct Round {
  GapFit without;
  double heldout_squares = 0.0;  // of `without`
  std::vector<Contender> contenders;
};

struct SearchLimits {
  std::size_t most_effects = 4;
  std::size_t most_fits = 9;        // per round
  double least_heldout_nats = 9.0;  // deflated; the chance of a false one is at most exp(-9) each
  double least_train_nats = 9.0;
  std::size_t most_poles = 4;        // of the linear core
  double least_core_nats = 3.0;      // held out, deflated, for a larger core
  double least_further_nats = 20.0;  // held out, deflated, for a further effect
  double least_share = 0.06;         // of what the strongest effect explains, for a further one
};

struct GapSearch {
  GapFit baseline;            // the linear model alone, under the final noise
  GapFit final;               // with all that was accepted
  std::vector<Round> rounds;  // in the order of the search; the last one ended it
  std::vector<Round> checks;  // for each accepted effect: the model without it, and who would take its place
  Screening last_look;        // from `final`: what is absent, and how clearly it would have shown
  double heldout_squares_before = 0.0;
  double heldout_squares_after = 0.0;
};

// Called before each longer piece of work with a word for it and the share done.
using Progress = std::function<void(const std::string& what, double share)>;

// `candidates` are the effects that the data can show at all, decoys among them.
GapSearch search_gap(GapProblem& train, GapProblem& heldout, const TrialModel& start,
                     std::span<const EffectInfo* const> candidates, const SearchLimits& limits,
                     const ForEach& for_each, const Progress& progress);

}  // namespace wheelwright::gap
