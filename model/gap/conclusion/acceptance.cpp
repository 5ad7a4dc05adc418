#include "model/gap/conclusion/acceptance.hpp"

#include <algorithm>

#include "model/effect_library.hpp"

namespace wheelwright::gap {
namespace {

// Counts that stood still are found by the data gate, not by free runs.
bool of_free_runs(const Finding& found) {
  return found.setting.name != dropout_name;
}

// A smooth effect after which what is left hangs together, or a sudden one that explains little beside it.
bool leaves_what_hangs_together(const Finding& found, double largest_nats) {
  constexpr double inflation_of_noise = 15.0;
  constexpr double little = 0.2;
  const EffectInfo* info = find_effect(found.setting.name);
  if (info == nullptr || !of_free_runs(found)) return false;
  return info->sudden ? found.heldout_gain_nats < little * largest_nats
                      : found.inflation > inflation_of_noise;
}

bool some_is_sure_by(const GapAnalysis& analysis, double nats) {
  return std::ranges::any_of(analysis.found, [nats](const Finding& found) {
    return found.heldout_gain_nats > nats && found.posterior > sure;
  });
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
  return some_figure_falls(figures, least_fall, is_beyond_chance(analysis) ? 0.0 : 1.0);
}

bool beyond_noise(const Wandering& by, double times) {
  return by.m_per_sqrt_s > times * largest_noise.m_per_sqrt_s ||
         by.rad_per_sqrt_s > times * largest_noise.rad_per_sqrt_s;
}

NoiseModel no_more_than_noise(const NoiseModel& noise) {
  NoiseModel limited = noise;
  for (const Channel channel :
       {Channel::left, Channel::right, Channel::forward, Channel::aside, Channel::turn}) {
    double& walk = limited.channel[static_cast<std::size_t>(channel)].walk_per_sqrt_s;
    walk =
        std::min(walk, channel == Channel::turn ? largest_noise.rad_per_sqrt_s : largest_noise.m_per_sqrt_s);
  }
  return limited;
}

bool is_the_smaller_part(const GapAnalysis& analysis, const Wandering& left) {
  constexpr double half = 0.5;
  constexpr double clearly = 1.15;  // real Creates wander by 26 mrad after what was named
  double largest_nats = 0.0;
  for (const Finding& found : analysis.found) largest_nats = std::max(largest_nats, found.heldout_gain_nats);
  const auto hangs_together = [&](const Finding& found) {
    return leaves_what_hangs_together(found, largest_nats);
  };
  const GapFigures& test = analysis.tail_held_out ? analysis.train : analysis.test;
  return !analysis.found.empty() && std::ranges::all_of(analysis.found, hangs_together) &&
         (beyond_noise(left, clearly) || largest_share_gone(analysis.train, test) < half);
}

}  // namespace wheelwright::gap
