// Analyses that came to given findings and figures.
#pragma once

#include <string>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/analysis.hpp"

namespace wheelwright::gap {

// Position errors in floors of noise.
inline GapFigures position(double before, double after) {
  const auto score = [](double value) {
    Score result;
    result.position_rms_m = AtHorizon{10.0, 0.01 * value};
    return result;
  };
  return {score(before), score(after), score(1.0)};
}

inline Finding finding(const std::string& effect, double nats, double posterior = 1.0,
                       double rival_share = 0.1) {
  Finding found;
  found.setting.name = effect;
  found.heldout_gain_nats = nats;
  found.posterior = posterior;
  found.rival_share = rival_share;
  return found;
}

inline GapAnalysis analysis_with(const std::vector<Finding>& found, const GapFigures& figures) {
  GapAnalysis analysis;
  analysis.found = found;
  analysis.train = analysis.test = figures;
  analysis.search.final.model = first_guess({}, 0.02, 0.25, 0.1, 0.02);
  for (const Finding& one : found) {
    analysis.search.final.model.effects.push_back({find_effect(one.setting.name), 0, one.setting.parameters});
  }
  analysis.search.selection_steps.emplace_back();
  return analysis;
}

}  // namespace wheelwright::gap
