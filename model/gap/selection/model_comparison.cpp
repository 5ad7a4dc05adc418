#include "model/gap/selection/model_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/gap/candidates/decoys.hpp"

namespace wheelwright::gap {
namespace {

constexpr double block_s = 2.0;  // longer than what is left hangs together
constexpr double largest_inflation = 30.0;

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

// Of several sizes, all have to be.
bool negligible(const TrialEffect& effect) {
  bool any = false;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const double least = effect.parameter_info(i).negligible;
    if (least == 0.0) continue;
    if (std::abs(effect.parameters[i]) >= least) return false;
    any = true;
  }
  return any;
}

const TrialEffect& effect_of(const Contender& contender) {
  const auto& effects = contender.fit.model.effects;
  return effects[effects.size() - 1 - contender.behind];
}

double largest_command_m_s(const GapProblem& problem) {
  double largest = 0.0;
  for (const GapRun& run : problem.runs()) {
    for (const WheelPair& command : run.commands_m_s)
      largest = std::max({largest, std::abs(command.left), std::abs(command.right)});
  }
  return largest;
}

}  // namespace

Contest::Contest(const GapProblem& train, const GapProblem& heldout, const SearchLimits& limits)
    : train_(train),
      heldout_(heldout),
      limits_(limits),
      largest_command_m_s_(std::max(largest_command_m_s(train), largest_command_m_s(heldout))) {}

// A sound robot acts 50 to 100 ms late (PAPER.md), and its motor's lag adds to that: a linear core holds it.
bool beyond_a_core(const TrialEffect& effect) {
  constexpr double reach_of_a_core_s = 0.12;
  return effect.info->linear && effect.parameters.front() > reach_of_a_core_s;
}

double Contest::price_of_a_parameter() const {
  return 0.5 * std::log(static_cast<double>(train_.readings() + heldout_.readings()));
}

double Contest::price(const TrialEffect& effect) const {
  auto parameters = effect.parameters.size();
  if (effect.info->by_wheel_angle && angles_differ_) {
    parameters += 2 * (train_.runs().size() + heldout_.runs().size() - 1);
  }
  return price_of_a_parameter() * static_cast<double>(parameters);
}

double Contest::price(const TrialModel& model) const {
  double sum = price_of_a_parameter() * static_cast<double>(model.core.size());
  for (const auto& effect : model.effects) sum += price(effect);
  return sum;
}

Contender Contest::judged(const GapFit& without, const std::vector<double>& heldout_without,
                          Contender contender) const {
  const GapFit& fit = contender.fit;
  contender.effect = effect_of(contender);
  contender.train_nats = 0.5 * (without.squares - fit.squares);
  const std::vector<double> heldout_with = heldout_.residuals(fit.model);
  contender.heldout_nats = 0.5 * (squares_of(heldout_without) - squares_of(heldout_with));
  contender.inflation = std::max(inflation_of(train_, without.residuals, fit.residuals),
                                 inflation_of(heldout_, heldout_without, heldout_with));
  if (contender.effect.info->by_wheel_angle && angles_differ_) {
    // Two angles were taken from each held-out run: that much they explain of mere noise.
    contender.heldout_nats -= contender.inflation * static_cast<double>(heldout_.runs().size());
  }
  contender.heldout_residuals = heldout_with;
  return contender;
}

void Contest::judge(Round& round) const {
  const std::vector<double> heldout_without = heldout_.residuals(round.without.model);
  round.heldout_squares = squares_of(heldout_without);
  // What an effect of no consequence explains, its core explains; what one out of character does, another.
  std::erase_if(round.contenders, [this](const Contender& contender) {
    const TrialEffect& effect = effect_of(contender);
    const auto& in_character = effect.info->in_character;
    return negligible(effect) ||
           (in_character && !in_character({effect.parameters, effect.variant}, largest_command_m_s_));
  });
  for (auto& contender : round.contenders) {
    contender = judged(round.without, heldout_without, std::move(contender));
  }
  // A fit that runs away on runs that it has not seen is no fit.
  std::erase_if(round.contenders, [this](const Contender& one) {
    return !std::isfinite(one.train_nats) || !std::isfinite(one.heldout_nats) || acts_linearly(one);
  });
  rank(round.contenders);
  leave_out_aliases(round.contenders);
}

// Where all that it is more than a lag plays next to no part in these runs, the core lacks a lag.
bool Contest::acts_linearly(const Contender& contender) const {
  const TrialEffect& effect = contender.effect;
  if (!effect.info->linear_part) return false;
  TrialModel linear = contender.fit.model;
  linear.effects[linear.effects.size() - 1 - contender.behind].parameters =
      effect.info->linear_part({effect.parameters, effect.variant});
  const double lost_nats = 0.5 * (squares_of(train_.residuals(linear)) - contender.fit.squares);
  return lost_nats < limits_.least_further_nats;
}

double Contest::inflation_between(const Contender& worse, const Contender& better) const {
  return std::max(inflation_of(train_, worse.fit.residuals, better.fit.residuals),
                  inflation_of(heldout_, worse.heldout_residuals, better.heldout_residuals));
}

// By likelihood less the price of the parameters. The best one is measured against the model without it, the
// others against the best one: how much correlation inflates a difference hangs on what the two differ in.
// One that only training or only held-out runs speak for comes behind all that both speak for.
void Contest::rank(std::vector<Contender>& contenders) const {
  if (contenders.empty()) return;
  const auto holds = [](const Contender& one) { return one.train_nats > 0.0 && one.heldout_nats > 0.0; };
  const auto nats = [](const Contender& one) { return one.train_nats + one.heldout_nats; };
  const Contender& best = *std::ranges::max_element(contenders, [&](const Contender& a, const Contender& b) {
    return std::pair(holds(a), nats(a)) < std::pair(holds(b), nats(b));
  });
  const double best_score = score_alone(best);
  for (auto& contender : contenders) {
    contender.score = best_score;
    if (&contender == &best) continue;
    contender.score -= (nats(best) - nats(contender)) / inflation_between(contender, best);
    contender.score -= price(contender.effect) - price(best.effect);
    if (!holds(contender)) contender.score = std::min(contender.score, 0.0);
  }
  std::ranges::sort(contenders, std::greater<>{}, &Contender::score);
}

// On some drives a decoy does what an effect of the library does (where both wheels are always told the same
// speed, each one's own and the other's are the same): one that explains the same as a name is no rival.
void Contest::leave_out_aliases(std::vector<Contender>& contenders) {
  constexpr double same = 0.01;  // of the score
  const auto is_named = [](const Contender& one) { return !is_decoy(*one.effect.info); };
  const auto named = std::ranges::find_if(contenders, is_named);
  if (named == contenders.end() || named->score <= 0.0) return;
  const double score = named->score;
  std::erase_if(contenders, [&](const Contender& one) {
    return !is_named(one) && std::abs(one.score - score) < same * score;
  });
}

double Contest::core_score(const Round& round, const GapFit& richer) const {
  const double train_nats = 0.5 * (round.without.squares - richer.squares);
  const double heldout_nats = 0.5 * (round.heldout_squares - squares_of(heldout_.residuals(richer.model)));
  const double inflation = std::max(inflation_of(train_, round.without.residuals, richer.residuals),
                                    round.contenders.empty() ? 1.0 : round.contenders.front().inflation);
  if (heldout_nats / inflation < limits_.least_core_nats) return 0.0;
  return (train_nats + heldout_nats) / inflation - price(richer.model) + price(round.without.model);
}

double Contest::advantage(const GapFit& one, const GapFit& other) const {
  const std::vector<double> heldout_one = heldout_.residuals(one.model);
  const std::vector<double> heldout_other = heldout_.residuals(other.model);
  const double nats =
      0.5 * (other.squares - one.squares + squares_of(heldout_other) - squares_of(heldout_one));
  const auto inflation = [&](const GapFit& worse, const std::vector<double>& heldout_worse,
                             const GapFit& better, const std::vector<double>& heldout_better) {
    return std::max(inflation_of(train_, worse.residuals, better.residuals),
                    inflation_of(heldout_, heldout_worse, heldout_better));
  };
  const double deflated = nats / (nats > 0.0 ? inflation(other, heldout_other, one, heldout_one)
                                             : inflation(one, heldout_one, other, heldout_other));
  return deflated - price(one.model) + price(other.model);
}

double Contest::score_alone(const Contender& contender) const {
  return (contender.train_nats + contender.heldout_nats) / contender.inflation - price(contender.effect);
}

bool Contest::good_enough(const Contender& contender) const {
  const double heldout_nats = contender.heldout_nats / contender.inflation;
  const double train_nats = contender.train_nats / contender.inflation;
  const bool both = heldout_nats > limits_.least_heldout_nats && train_nats > limits_.least_train_nats;
  const bool confirmed = heldout_nats > limits_.confirming_nats && train_nats > limits_.clear_train_nats;
  return (both || confirmed) && score_alone(contender) > 0.0;
}

bool Contest::clear(const Contender& contender) const {
  return good_enough(contender) &&
         contender.heldout_nats / contender.inflation > limits_.least_further_nats &&
         contender.train_nats / contender.inflation > limits_.least_further_nats;
}

bool Contest::worth_adding(const Contender& contender, const std::vector<Round>& so_far) const {
  double largest = 0.0;
  for (const auto& round : so_far) {
    if (round.contenders.empty()) continue;
    const Contender& first = round.contenders.front();
    largest = std::max(largest, first.heldout_nats / first.inflation);
  }
  const double nats = contender.heldout_nats / contender.inflation;
  // What a wrong shape of the strongest effect leaves, another may fit, but not so that noise alone is left.
  constexpr double of_noise_alone = 2.0;
  const double least_share =
      contender.inflation < of_noise_alone ? limits_.least_share_before_noise : limits_.least_share;
  return good_enough(contender) &&
         (largest == 0.0 || nats > std::max(limits_.least_further_nats, least_share * largest));
}

bool Contest::clearly_better(const GapFit& with, const GapFit& without) const {
  const std::vector<double> heldout_without = heldout_.residuals(without.model);
  const std::vector<double> heldout_with = heldout_.residuals(with.model);
  const double inflation = std::max(inflation_of(train_, without.residuals, with.residuals),
                                    inflation_of(heldout_, heldout_without, heldout_with));
  const double train_nats = 0.5 * (without.squares - with.squares);
  const double heldout_nats = 0.5 * (squares_of(heldout_without) - squares_of(heldout_with));
  return train_nats / inflation > limits_.least_further_nats &&
         heldout_nats / inflation > limits_.least_further_nats;
}

bool Contest::stands_beside(const GapFit& both, const Contender& decoy) const {
  return clearly_better(both, decoy.fit);
}

bool Contest::explains_something_else(const GapFit& both, const Contender& one,
                                      const Contender& other) const {
  constexpr double about_as_much = 0.7;
  const double train_nats = 0.5 * (other.fit.squares - both.squares);
  const double heldout_nats =
      0.5 * (squares_of(other.heldout_residuals) - squares_of(heldout_.residuals(both.model)));
  return train_nats > about_as_much * one.train_nats && heldout_nats > about_as_much * one.heldout_nats;
}

bool Contest::pair_worth_adding(const GapFit& pair, const Round& round) const {
  return clearly_better(pair, round.without) &&
         (round.contenders.empty() || advantage(pair, round.contenders.front().fit) > 0.0);
}

}  // namespace wheelwright::gap
