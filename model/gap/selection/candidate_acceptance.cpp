#include "model/gap/selection/candidate_acceptance.hpp"

#include <algorithm>
#include <set>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/selection/candidate_evaluation.hpp"

namespace wheelwright::gap {

// Where free runs are off by more than noise, something is missing: a further effect may be small beside the
// first one, and need not be clear where free runs come closer by it.
bool CandidateAcceptance::helps_what_is_off(const Candidate& candidate, const SelectionStep& step) const {
  if (!comparison_.good_enough(candidate) || !free_runs_.still_off(step.without.model)) return false;
  return comparison_.clear(candidate) || free_runs_.closer(step.without.model, candidate.fit.model);
}

bool CandidateAcceptance::stands_beside(const Candidate& candidate, const Candidate& other) const {
  TrialModel both = other.fit.model;
  both.effects.push_back(candidate.effect);
  return comparison_.stands_beside(train_.fit(both, steps_of_a_fit), other);
}

// What a wrong shape of a strong effect leaves, a name and a decoy explain in part, each another one. Where a
// decoy that explains much alone explains nothing beside a name, the name is no such shape.
bool CandidateAcceptance::explains_what_decoys_do(const Candidate& candidate,
                                                  const SelectionStep& step) const {
  if (!comparison_.clear(candidate)) return false;
  const auto decoy = std::ranges::find_if(step.candidates, [&](const Candidate& other) {
    return is_decoy(*other.effect.info) && comparison_.clear(other);
  });
  return decoy != step.candidates.end() && !stands_beside(*decoy, candidate);
}

bool CandidateAcceptance::accepted(const Candidate& candidate, const SelectionStep& step,
                                   std::span<const SelectionStep> so_far) const {
  if (!comparison_.worth_adding(candidate, so_far) && !helps_what_is_off(candidate, step) &&
      !explains_what_decoys_do(candidate, step))
    return false;
  const Candidate& best = step.candidates.front();
  return candidate.effect.info == best.effect.info || stands_beside(candidate, best);
}

const Candidate* CandidateAcceptance::next_effect(const SelectionStep& step,
                                                  std::span<const SelectionStep> so_far) const {
  if (so_far.size() >= limits_.max_effects) return nullptr;
  std::set<const EffectInfo*> asked;  // in each of its variants
  for (const Candidate& candidate : step.candidates) {
    if (is_decoy(*candidate.effect.info) || !comparison_.good_enough(candidate)) continue;
    asked.insert(candidate.effect.info);
    if (asked.size() > max_costly_candidates) return nullptr;
    if (accepted(candidate, step, so_far)) return &candidate;
  }
  return nullptr;
}

bool CandidateAcceptance::pair_accepted(const SelectionStep& step, std::size_t steps_so_far) const {
  return step.pair && steps_so_far < limits_.max_effects && comparison_.pair_worth_adding(*step.pair, step);
}

std::vector<const Candidate*> CandidateAcceptance::first_effects(const SelectionStep& first) const {
  std::vector<const Candidate*> all;
  const Candidate* best = best_named(first);
  if (best == nullptr || limits_.max_effects == 0 || !accepted(*best, first, {})) return all;
  for (const auto& candidate : first.candidates) {
    const bool known = std::ranges::any_of(
        all, [&](const Candidate* other) { return other->effect.info == candidate.effect.info; });
    if (known || is_decoy(*candidate.effect.info) || !comparison_.good_enough(candidate)) continue;
    if (candidate.score < limits_.min_path_score * best->score) break;
    all.push_back(&candidate);
    if (all.size() == limits_.max_paths) break;
  }
  return all;
}

}  // namespace wheelwright::gap
