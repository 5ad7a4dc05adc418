#include "model/gap/conclusion/acceptance.hpp"

#include <algorithm>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright::gap {
namespace {

// Counts that stood still are found by the data gate, not by free runs.
bool of_free_runs(const Finding& found) {
  return found.setting.name != dropout_name;
}

bool is_sure_by(const Finding& found, double nats) {
  return found.heldout_gain_nats > nats && found.posterior > sure;
}

bool some_is_sure_by(const GapAnalysis& analysis, double nats) {
  return std::ranges::any_of(analysis.found,
                             [nats](const Finding& found) { return is_sure_by(found, nats); });
}

}  // namespace

Excess what_is_left(const GapAnalysis& analysis) {
  return largest_excess(analysis.train, analysis.tail_held_out ? analysis.train : analysis.test);
}

bool is_beyond_chance(const GapAnalysis& analysis) {
  constexpr double not_by_chance_nats = 25.0;
  return some_is_sure_by(analysis, not_by_chance_nats);
}

bool closes_the_gap(const GapAnalysis& analysis, bool linear_left_out) {
  const GapFigures& figures = analysis.tail_held_out ? analysis.train : analysis.test;
  const auto& effects = analysis.search.final.model.effects;
  const bool linear = linear_left_out || std::ranges::all_of(effects, [](const TrialEffect& effect) {
                        return effect.info->linear;
                      });
  if (linear) return shows(figures);
  // Where no figure lies above the noise, or one becomes worse, a small regularity of the robot is not a gap,
  // and a figure may fall by chance.
  const GapFigures turned_round{figures.after, figures.before, figures.floor};
  const bool some_rises = some_figure_falls(turned_round, 0.1, 0.0);
  const bool little_is_enough = some_figure_above_noise(figures) && !some_rises;
  if (some_is_sure_by(analysis, little_is_enough ? 30.0 : beyond_doubt_nats)) return true;
  return some_figure_falls(figures, min_fall, is_beyond_chance(analysis) ? 0.0 : 1.0);
}

NoiseModel no_more_than_noise(const NoiseModel& noise) {
  NoiseModel limited = noise;
  for (const Channel channel :
       {Channel::left, Channel::right, Channel::forward, Channel::aside, Channel::turn}) {
    double& walk = limited.channel[static_cast<std::size_t>(channel)].walk_per_sqrt_s;
    walk =
        std::min(walk, channel == Channel::turn ? largest_drift_rad_per_sqrt_s : largest_drift_m_per_sqrt_s);
  }
  return limited;
}

bool closes_nothing_untouched(const GapAnalysis& analysis) {
  const auto acts_there = [](const Finding& found) { return of_free_runs(found) && found.acts_untouched; };
  if (!analysis.untouched || std::ranges::none_of(analysis.found, acts_there)) return false;
  if (!some_figure_falls(analysis.test, min_fall, 0.0)) return true;
  const auto fall = common_fall(analysis.test);
  const bool is_beyond_doubt = std::ranges::any_of(analysis.found, [&](const Finding& found) {
    return acts_there(found) && is_sure_by(found, beyond_doubt_nats);
  });
  return fall && *fall < min_fall && !is_beyond_doubt;
}

bool explains_the_smaller_part(const GapAnalysis& analysis) {
  constexpr double half = 0.5;
  const auto is_sudden = [](const Finding& found) { return find_effect(found.setting.name)->sudden; };
  const bool any_name = std::ranges::any_of(analysis.found, of_free_runs);
  const bool any_sudden = std::ranges::any_of(
      analysis.found, [&](const Finding& found) { return of_free_runs(found) && is_sudden(found); });
  const GapFigures& test = analysis.tail_held_out ? analysis.train : analysis.test;
  return any_name && !analysis.check.passed && largest_share_gone(test) < (any_sudden ? 0.0 : half);
}

}  // namespace wheelwright::gap
