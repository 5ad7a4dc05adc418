#include "model/gap/conclusion/acceptance.hpp"

#include <algorithm>

namespace wheelwright::gap {
namespace {

bool some_is_sure_by(const GapAnalysis& analysis, double nats) {
  return std::ranges::any_of(analysis.found,
                             [nats](const Finding& found) { return is_sure_by(found, nats); });
}

}  // namespace

bool is_sure_by(const Finding& found, double nats) {
  return found.heldout_gain_nats > nats && found.posterior > sure_posterior;
}

Excess residual_excess(const GapAnalysis& analysis) {
  return largest_excess(analysis.train, analysis.tail_held_out ? analysis.train : analysis.test);
}

bool is_beyond_chance(const GapAnalysis& analysis) {
  constexpr double not_by_chance_nats = 25.0;
  return some_is_sure_by(analysis, not_by_chance_nats);
}

bool has_long_delay_beyond_doubt(const GapAnalysis& analysis) {
  const TrialModel& model = analysis.search.final.model;
  return std::ranges::any_of(analysis.found, [&](const Finding& found) {
    const auto effect = std::ranges::find_if(
        model.effects, [&](const TrialEffect& one) { return one.info->name == found.setting.name; });
    return effect != model.effects.end() && beyond_a_linear_part(model, *effect) &&
           is_sure_by(found, beyond_doubt_nats);
  });
}

bool closes_the_gap(const GapAnalysis& analysis, bool linear_left_out) {
  const GapFigures& figures = analysis.tail_held_out ? analysis.train : analysis.test;
  const auto& effects = analysis.search.final.model.effects;
  const bool linear = linear_left_out || std::ranges::all_of(effects, [](const TrialEffect& effect) {
                        return effect.info->linear;
                      });
  if (linear) return shows(figures) || has_long_delay_beyond_doubt(analysis);
  // Where no figure lies above the noise, or one becomes worse, a small regularity of the robot is not a gap,
  // and a figure may fall by chance.
  const GapFigures turned_round{figures.after, figures.before, figures.floor};
  const bool some_rises = some_figure_falls(turned_round, 0.1, 0.0);
  const bool little_is_enough = some_figure_above_noise(figures) && !some_rises;
  if (some_is_sure_by(analysis, little_is_enough ? 30.0 : beyond_doubt_nats)) return true;
  if (all_figures_negligible(figures) && !is_beyond_chance(analysis)) return false;
  return some_figure_falls(figures, min_fall, is_beyond_chance(analysis) ? 0.0 : 1.0);
}

NoiseModel with_bounded_drift(const NoiseModel& noise) {
  NoiseModel limited = noise;
  for (const Channel channel :
       {Channel::left, Channel::right, Channel::forward, Channel::aside, Channel::turn}) {
    double& walk = limited.channel[static_cast<std::size_t>(channel)].walk_per_sqrt_s;
    walk =
        std::min(walk, channel == Channel::turn ? largest_drift_rad_per_sqrt_s : largest_drift_m_per_sqrt_s);
  }
  return limited;
}

}  // namespace wheelwright::gap
