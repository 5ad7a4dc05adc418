#include "model/gap/gap_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "model/gap/decoys.hpp"

namespace wheelwright::gap {
namespace {

constexpr int steps_of_a_fit = 10;
constexpr int steps_of_a_refit = 5;
constexpr double least_screened_nats = 4.0;
constexpr double least_screened_share = 0.08;  // of the best one's: less does not become the best by a fit
constexpr double block_s = 2.0;                // longer than what is left hangs together
constexpr double largest_inflation = 30.0;

double squares_of(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

// By how much the variance of an effect's likelihood gain exceeds that of white residuals: sums over blocks
// of time of residual times change, against the sum of squared changes.
double inflation_of(const GapProblem& problem, const std::vector<double>& without,
                    const std::vector<double>& with) {
  std::map<std::pair<std::size_t, std::size_t>, double> blocks;
  double power = 0.0;
  const auto& places = problem.places();
  for (std::size_t i = 0; i < with.size(); ++i) {
    const double change = without[i] - with[i];
    const double period_s = problem.runs()[places[i].run].period_s;
    const auto block = static_cast<std::size_t>(static_cast<double>(places[i].period) * period_s / block_s);
    blocks[{places[i].run, block}] += with[i] * change;
    power += change * change;
  }
  if (!(power > 0.0)) return 1.0;
  double variance = 0.0;
  for (const auto& [key, sum] : blocks) variance += sum * sum;
  return std::clamp(variance / power, 1.0, largest_inflation);
}

class Search {
 public:
  Search(GapProblem& train, GapProblem& heldout, std::span<const EffectInfo* const> candidates,
         const SearchLimits& limits, const ForEach& for_each, const Progress& progress)
      : train_(train),
        heldout_(heldout),
        candidates_(candidates.begin(), candidates.end()),
        limits_(limits),
        for_each_(for_each),
        progress_(progress) {}

  GapSearch run(const TrialModel& start);

 private:
  GapFit settle(TrialModel model, int passes);
  void set_noise_left_by(const TrialModel& model);
  Round look(const GapFit& without, const std::vector<const EffectInfo*>& candidates,
             std::vector<TrialEffect> more_starts);
  Contender judged(const GapFit& without, const std::vector<double>& heldout_without, GapFit fit) const;
  void judge_all(Round& round);
  void rank(std::vector<Contender>& contenders) const;
  bool good_enough(const Contender& contender) const;
  bool worth_adding(const Contender& contender, const GapSearch& so_far) const;
  const Contender* best_named(const Round& round) const;
  std::vector<const EffectInfo*> absent_from(const TrialModel& model) const;
  bool improve_by_swaps(GapSearch& result);
  std::optional<GapFit> better_core(const Round& round) const;
  bool stands_beside(const Contender& named, const Contender& decoy) const;

  GapProblem& train_;
  GapProblem& heldout_;
  std::vector<const EffectInfo*> candidates_;
  SearchLimits limits_;
  const ForEach& for_each_;
  const Progress& progress_;
};

void Search::set_noise_left_by(const TrialModel& model) {
  const NoiseModel noise = train_.noise_left_by(model);
  train_.set_noise(noise);
  heldout_.set_noise(noise);
}

// Fit and noise depend on each other.
GapFit Search::settle(TrialModel model, int passes) {
  GapFit fit;
  for (int pass = 0; pass < passes; ++pass) {
    set_noise_left_by(model);
    fit = train_.fit(model, steps_of_a_fit);
    model = fit.model;
  }
  return fit;
}

std::vector<const EffectInfo*> Search::absent_from(const TrialModel& model) const {
  std::vector<const EffectInfo*> absent;
  for (const EffectInfo* info : candidates_) {
    const auto same = [info](const TrialEffect& effect) { return effect.info == info; };
    if (std::ranges::none_of(model.effects, same)) absent.push_back(info);
  }
  return absent;
}

Contender Search::judged(const GapFit& without, const std::vector<double>& heldout_without,
                         GapFit fit) const {
  Contender contender;
  contender.effect = fit.model.effects.back();
  contender.train_nats = 0.5 * (without.squares - fit.squares);
  const std::vector<double> heldout_with = heldout_.residuals(fit.model);
  contender.heldout_nats = 0.5 * (squares_of(heldout_without) - squares_of(heldout_with));
  contender.inflation = std::max(inflation_of(train_, without.residuals, fit.residuals),
                                 inflation_of(heldout_, heldout_without, heldout_with));
  contender.fit = std::move(fit);
  return contender;
}

void Search::judge_all(Round& round) {
  const std::vector<double> heldout_without = heldout_.residuals(round.without.model);
  round.heldout_squares = squares_of(heldout_without);
  for (auto& contender : round.contenders) {
    contender = judged(round.without, heldout_without, std::move(contender.fit));
  }
  rank(round.contenders);
}

// By likelihood less the price of the parameters. How much correlation inflates the likelihoods is taken from
// the best one: a wrong effect leaves more behind, and its own inflation would say so twice.
void Search::rank(std::vector<Contender>& contenders) const {
  if (contenders.empty()) return;
  const auto nats = [](const Contender& contender) { return contender.train_nats + contender.heldout_nats; };
  const double inflation = std::ranges::max_element(contenders, {}, nats)->inflation;
  const double readings = static_cast<double>(train_.readings() + heldout_.readings());
  for (auto& contender : contenders) {
    const double parameters = static_cast<double>(contender.effect.parameters.size());
    contender.score = nats(contender) / inflation - 0.5 * parameters * std::log(readings);
  }
  std::ranges::sort(contenders, std::greater<>{}, &Contender::score);
}

// Screens and fits. The noise is then taken from what the best one leaves, since before, it holds what is
// missing; and all are fitted again under it.
Round Search::look(const GapFit& without, const std::vector<const EffectInfo*>& candidates,
                   std::vector<TrialEffect> more_starts) {
  Round round{without, 0.0, {}};
  const Screening screening = screen(train_, without, candidates, for_each_);
  std::vector<TrialEffect> starts = std::move(more_starts);
  for (const auto& screened : screening.best) {
    if (starts.size() >= limits_.most_fits || screened.gain_nats < least_screened_nats) break;
    if (screened.gain_nats < least_screened_share * screening.best.front().gain_nats) break;
    starts.push_back(screened.start);
  }
  round.contenders.resize(starts.size());
  for_each_(starts.size(), [&](std::size_t i) {
    TrialModel with = without.model;
    with.effects.push_back(starts[i]);
    round.contenders[i].fit = train_.fit(with, steps_of_a_fit, train_.part_of(starts[i]));
  });
  judge_all(round);
  if (round.contenders.empty() || round.contenders.front().score < limits_.least_train_nats) return round;
  set_noise_left_by(round.contenders.front().fit.model);
  round.without = train_.fit(round.without.model, steps_of_a_refit);
  for_each_(round.contenders.size(), [&](std::size_t i) {
    const TrialModel& model = round.contenders[i].fit.model;
    round.contenders[i].fit = train_.fit(model, steps_of_a_refit, train_.part_of(model.effects.back()));
  });
  judge_all(round);
  return round;
}

bool negligible(const TrialEffect& effect) {
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    if (std::abs(effect.parameters[i]) < effect.info->parameters[i].negligible) return true;
  }
  return false;
}

bool Search::good_enough(const Contender& contender) const {
  return !negligible(contender.effect) &&
         contender.heldout_nats / contender.inflation > limits_.least_heldout_nats &&
         contender.train_nats / contender.inflation > limits_.least_train_nats && contender.score > 0.0;
}

// A second effect that explains next to nothing beside the first is more often the first one's shape than an
// effect.
bool Search::worth_adding(const Contender& contender, const GapSearch& so_far) const {
  double largest = 0.0;
  for (const auto& round : so_far.rounds) {
    if (round.contenders.empty()) continue;
    const Contender& first = round.contenders.front();
    largest = std::max(largest, first.heldout_nats / first.inflation);
  }
  const double nats = contender.heldout_nats / contender.inflation;
  return good_enough(contender) &&
         (largest == 0.0 || nats > std::max(limits_.least_further_nats, limits_.least_share * largest));
}

const Contender* Search::best_named(const Round& round) const {
  for (const auto& contender : round.contenders) {
    if (!is_decoy(*contender.effect.info)) return &contender;
  }
  return nullptr;
}

// A richer linear core is a rival too: it wins where what is missing is linear.
std::optional<GapFit> Search::better_core(const Round& round) const {
  const TrialModel& present = round.without.model;
  std::vector<TrialModel> richer;
  if (present.shape.poles < limits_.most_poles) richer.push_back(present.with_larger_core());
  if (!present.shape.crossed && !present.shape.shared) richer.push_back(present.with_crossed_core());
  std::optional<GapFit> best;
  double best_score = round.contenders.empty() ? 0.0 : std::max(0.0, round.contenders.front().score);
  for (const TrialModel& start : richer) {
    GapFit fit = train_.fit(start, 2 * steps_of_a_fit, train_.part_of(EffectStage::command));
    const double train_nats = 0.5 * (round.without.squares - fit.squares);
    const double heldout_nats = 0.5 * (round.heldout_squares - squares_of(heldout_.residuals(fit.model)));
    const double inflation = std::max(inflation_of(train_, round.without.residuals, fit.residuals),
                                      round.contenders.empty() ? 1.0 : round.contenders.front().inflation);
    const double readings = static_cast<double>(train_.readings() + heldout_.readings());
    const double parameters = static_cast<double>(fit.model.core.size() - present.core.size());
    const double score = (train_nats + heldout_nats) / inflation - 0.5 * parameters * std::log(readings);
    if (score <= best_score || heldout_nats / inflation < limits_.least_core_nats) continue;
    best_score = score;
    best = std::move(fit);
  }
  return best;
}

// A decoy that explains more does not speak against a name that explains something else: with the decoy in
// the model, the name must still gain what it takes to be named.
bool Search::stands_beside(const Contender& named, const Contender& decoy) const {
  TrialModel with_both = decoy.fit.model;
  with_both.effects.push_back(named.effect);
  const GapFit both = train_.fit(with_both, steps_of_a_fit);
  const std::vector<double> heldout_without = heldout_.residuals(decoy.fit.model);
  const std::vector<double> heldout_with = heldout_.residuals(both.model);
  const double inflation = std::max(inflation_of(train_, decoy.fit.residuals, both.residuals),
                                    inflation_of(heldout_, heldout_without, heldout_with));
  const double train_nats = 0.5 * (decoy.fit.squares - both.squares);
  const double heldout_nats = 0.5 * (squares_of(heldout_without) - squares_of(heldout_with));
  return train_nats / inflation > limits_.least_further_nats &&
         heldout_nats / inflation > limits_.least_further_nats;
}

// For each accepted effect: would another one do better in its place, now that the others are there?
bool Search::improve_by_swaps(GapSearch& result) {
  bool changed = false;
  result.checks.clear();
  for (std::size_t i = 0; i < result.final.model.effects.size(); ++i) {
    TrialModel others = result.final.model;
    const TrialEffect present = others.effects[i];
    others.effects.erase(others.effects.begin() + static_cast<std::ptrdiff_t>(i));
    const GapFit without = train_.fit(others, steps_of_a_fit);
    Round round = look(without, absent_from(others), {present});
    const Contender* best = best_named(round);
    if (best != nullptr && best->effect.info != present.info && good_enough(*best)) {
      result.final = best->fit;
      changed = true;
    } else if (best == nullptr || !good_enough(*best)) {
      result.final = round.without;  // no longer needed beside the others
      changed = true;
    }
    result.checks.push_back(std::move(round));
    if (changed) break;
  }
  return changed;
}

GapSearch Search::run(const TrialModel& start) {
  GapSearch result;
  progress_("linear model", 0.0);
  result.final = settle(start, 3);
  for (std::size_t found = 0; found <= limits_.most_effects; ++found) {
    progress_("effect " + std::to_string(found + 1), 0.1 + 0.6 * static_cast<double>(found) / 4.0);
    Round round = look(result.final, absent_from(result.final.model), {});
    while (const auto larger = better_core(round)) {
      result.final = settle(larger->model, 1);
      round = look(result.final, absent_from(result.final.model), {});
    }
    const Contender* best = best_named(round);
    const bool accepted = found < limits_.most_effects && best != nullptr && worth_adding(*best, result) &&
                          (best == round.contenders.data() || stands_beside(*best, round.contenders.front()));
    result.final = accepted ? best->fit : round.without;
    result.rounds.push_back(std::move(round));
    if (!accepted) break;
  }
  progress_("rivals", 0.75);
  for (int tries = 0; tries < 3 && !result.final.model.effects.empty(); ++tries) {
    if (!improve_by_swaps(result)) break;
  }
  progress_("what would have shown", 0.92);
  result.final = settle(result.final.model, 1);
  TrialModel linear = result.final.model;
  linear.effects.clear();
  result.baseline = train_.fit(linear, steps_of_a_fit);
  std::vector<const EffectInfo*> named;
  for (const EffectInfo* info : absent_from(result.final.model)) {
    if (!is_decoy(*info)) named.push_back(info);
  }
  result.last_look = screen(train_, result.final, named, for_each_);
  result.heldout_squares_before = squares_of(heldout_.residuals(result.baseline.model));
  result.heldout_squares_after = squares_of(heldout_.residuals(result.final.model));
  return result;
}

}  // namespace

GapSearch search_gap(GapProblem& train, GapProblem& heldout, const TrialModel& start,
                     std::span<const EffectInfo* const> candidates, const SearchLimits& limits,
                     const ForEach& for_each, const Progress& progress) {
  return Search(train, heldout, candidates, limits, for_each, progress).run(start);
}

}  // namespace wheelwright::gap
