#include "model/gap/conclusion/finding.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "model/gap/candidates/screening_pairs.hpp"
#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright::gap {
namespace {

constexpr double smallest_p = 1e-300;  // a chance of zero is never claimed
// Assumed, not measured: each one lacks ten counts or more (encoder_dropout.cpp), so that what is left of
// doubt is whether the wheel turned.
constexpr double nats_of_a_dropout = 5.0;

// Probability of each name in the place of an accepted effect, the others being there.
Finding finding(const GapSearch& search, std::size_t index) {
  Finding found;
  found.setting = search.final.model.settings()[index];
  if (index >= search.checks.size()) return found;
  std::map<std::string, double> best_score;
  const auto& candidates = search.checks[index].candidates;
  for (const auto& candidate : candidates) {
    const std::string name = is_decoy(*candidate.effect.info) ? "decoy" : candidate.effect.info->name;
    const auto entry = best_score.try_emplace(name, candidate.score).first;
    entry->second = std::max(entry->second, candidate.score);
    if (name == found.setting.name && found.heldout_gain_nats == 0.0) {
      found.heldout_gain_nats = candidate.deflated_unseen_nats();
      found.p_value = std::clamp(std::exp(-found.heldout_gain_nats), smallest_p, 1.0);
    }
  }
  double largest = 0.0;  // the score of adding nothing
  for (const auto& [name, score] : best_score) largest = std::max(largest, score);
  double sum = std::exp(-largest);
  for (const auto& [name, score] : best_score) sum += std::exp(score - largest);
  const double own_score = best_score[found.setting.name];
  for (const auto& [name, score] : best_score) {
    if (name != found.setting.name && own_score > 0.0) {
      found.rival_share = std::max(found.rival_share, score / own_score);
    }
    const double posterior = std::exp(score - largest) / sum;
    if (name == found.setting.name) {
      found.posterior = posterior;
    } else {
      found.rivals.push_back({name, posterior});
    }
  }
  std::ranges::sort(found.rivals, std::greater<>{}, &Rival::posterior);
  return found;
}

// What was found first explained most by itself. What else was found may have taken some of that over since:
// only what would be missed far more stands before it.
void put_first_what_is_missed_most(std::vector<Finding>& found) {
  constexpr double far_more = 3.0;
  if (found.empty()) return;
  const auto most = std::ranges::max_element(found, {}, &Finding::heldout_gain_nats);
  const bool other_first = most->heldout_gain_nats > far_more * found.front().heldout_gain_nats;
  std::ranges::stable_sort(found.begin() + (other_first ? 0 : 1), found.end(), std::greater<>{},
                           &Finding::heldout_gain_nats);
}

}  // namespace

std::vector<Finding> findings_of(const GapSearch& search) {
  std::vector<Finding> all;
  auto from = search.intervals.begin();
  for (std::size_t i = 0; i < search.final.model.effects.size(); ++i) {
    Finding found = finding(search, i);
    const auto to = from + static_cast<std::ptrdiff_t>(found.setting.parameters.size());
    found.intervals.assign(from, to);
    from = to;
    all.push_back(std::move(found));
  }
  put_first_what_is_missed_most(all);
  return all;
}

void add_rivals_that_cannot_show(std::span<Finding> found, std::span<const Untestable> untestable,
                                 double longest_run_s) {
  constexpr double evenly = 2.0;       // time constant of a drift, in runs
  constexpr double runs_freely = 0.1;  // sliding friction, of what breaking away needs beyond it
  const auto cannot_show = [&](std::string_view name) {
    return std::ranges::find(untestable, name, &Untestable::effect) != untestable.end();
  };
  const auto add = [](Finding& finding, const std::string& rival) {
    finding.posterior *= 0.5;
    finding.rivals.insert(finding.rivals.begin(), {rival, finding.posterior});
    finding.rival_share = 1.0;
  };
  for (Finding& finding : found) {
    const std::string& name = finding.setting.name;
    if (name == "coulomb_friction" && cannot_show("floor_slope") && cannot_show("backlash")) {
      add(finding, "floor_slope");
    }
    // A wheel that is late on starting and runs freely then may only have had play to take up.
    if (name == "stiction" && cannot_show("backlash") &&
        finding.setting.parameters[1] < runs_freely * finding.setting.parameters[0]) {
      add(finding, "backlash");
    }
    if (name == "gain_drift" && cannot_show("voltage_sag") &&
        finding.setting.parameters[1] > evenly * longest_run_s) {
      add(finding, "voltage_sag");
    }
  }
}

std::optional<Finding> dropout_finding(std::span<const Dropout> dropouts, double watched_s) {
  if (dropouts.size() < more_than_chance || watched_s <= 0.0) return std::nullopt;
  double lost_s = 0.0;
  for (const auto& dropout : dropouts) lost_s += dropout.duration_s;
  Finding found;
  found.setting = {std::string(dropout_name),
                   "",
                   {std::min(1.0, lost_s / watched_s), lost_s / static_cast<double>(dropouts.size())}};
  const double share = found.setting.parameters[0];
  const double relative = deviations_in_ci95 / std::sqrt(static_cast<double>(dropouts.size()));
  found.intervals = {{share * std::max(0.0, 1.0 - relative), std::min(1.0, share * (1.0 + relative))},
                     {found.setting.parameters[1] * std::max(0.0, 1.0 - relative),
                      found.setting.parameters[1] * (1.0 + relative)}};
  found.heldout_gain_nats = nats_of_a_dropout * static_cast<double>(dropouts.size());
  found.p_value = std::exp(-found.heldout_gain_nats);
  found.posterior = 1.0 - found.p_value;
  return found;
}

std::vector<std::string> names_without_size(std::span<const Finding> found) {
  std::vector<std::string> names;
  for (const Finding& one : found) {
    const EffectInfo* info = find_effect(one.setting.name);
    if (info == nullptr || one.intervals.empty()) continue;
    const auto& parameters = info->parameters_of(variant_index(*info, one.setting.variant));
    std::size_t sizes = 0;
    bool may_be_none = true;
    for (std::size_t i = 0; i < parameters.size() && i < one.intervals.size(); ++i) {
      if (!parameters[i].scales_effect) continue;
      ++sizes;
      may_be_none =
          vanishes_at_zero(parameters[i]) && one.intervals[i].lower <= 0.0 && one.intervals[i].upper >= 0.0;
    }
    if (sizes == 1 && may_be_none) names.push_back(one.setting.name);
  }
  return names;
}

}  // namespace wheelwright::gap
