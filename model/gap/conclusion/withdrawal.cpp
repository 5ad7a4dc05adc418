#include "model/gap/conclusion/withdrawal.hpp"

#include <algorithm>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/conclusion/acceptance.hpp"

namespace wheelwright::gap {
namespace {

// Counts that stood still are found by the data gate, not by free runs.
bool of_free_runs(const Finding& found) {
  return found.setting.name != dropout_name;
}

}  // namespace

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

bool explains_the_smaller_part(const GapAnalysis& analysis, double share_gone) {
  constexpr double half = 0.5;
  const auto is_sudden = [](const Finding& found) { return find_effect(found.setting.name)->sudden; };
  const bool any_name = std::ranges::any_of(analysis.found, of_free_runs);
  const bool any_sudden = std::ranges::any_of(
      analysis.found, [&](const Finding& found) { return of_free_runs(found) && is_sudden(found); });
  return any_name && !analysis.check.passed && share_gone < (any_sudden ? 0.0 : half);
}

}  // namespace wheelwright::gap
