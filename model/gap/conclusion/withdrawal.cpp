#include "model/gap/conclusion/withdrawal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/gap/conclusion/acceptance.hpp"

namespace wheelwright::gap {
namespace {

// Counts that stood still are found by the data gate, not by free runs.
bool of_free_runs(const Finding& found) {
  return found.setting.name != dropout_name;
}

// What a model that was given has already is nothing that it lacks, however much a linear model lacks it.
bool is_in(const RobotModel& model, const Finding& found) {
  return std::ranges::any_of(
      model.effects, [&](const AddedEffect& effect) { return effect.setting.name == found.setting.name; });
}

// Whether held-out and untouched runs put a name beyond doubt, whatever their figures do: where a wheel that
// sticks comes loose is beyond prediction, and free runs then depart from each other however right the name.
bool some_is_beyond_doubt_untouched(const GapAnalysis& analysis) {
  return analysis.untouched && std::ranges::any_of(analysis.found, [&](const Finding& found) {
           return of_free_runs(found) && found.acts_untouched && !is_in(analysis.before, found) &&
                  is_sure_by(found, beyond_doubt_nats) &&
                  found.test_gain_nats.value_or(0.0) > beyond_doubt_nats;
         });
}

}  // namespace

std::vector<std::string> unconfirmed_names(const GapAnalysis& analysis) {
  constexpr double min_test_gain_nats = 10.0;
  std::vector<std::string> names;
  if (!analysis.untouched) return names;
  for (const Finding& found : analysis.found) {
    if (!of_free_runs(found) || !found.acts_untouched || is_in(analysis.before, found)) continue;
    if (is_sure_by(found, beyond_doubt_nats)) continue;
    if (found.test_gain_nats.value_or(0.0) < min_test_gain_nats) names.push_back(found.setting.name);
  }
  return names;
}

bool closes_nothing_untouched(const GapAnalysis& analysis) {
  const auto acts_there = [](const Finding& found) { return of_free_runs(found) && found.acts_untouched; };
  if (!analysis.untouched || std::ranges::none_of(analysis.found, acts_there)) return false;
  if (some_is_beyond_doubt_untouched(analysis)) return false;
  const auto fall = common_fall(analysis.test);
  return !some_figure_falls(analysis.test, min_fall, 0.0) || (fall && *fall < min_fall);
}

double share_of_evidence(const GapAnalysis& analysis) {
  const double gain_nats = std::max(0.0, analysis.names_gain_nats);
  const double left_nats = -std::log(std::max(analysis.check.p_value, std::numeric_limits<double>::min()));
  return gain_nats > 0.0 ? gain_nats / (gain_nats + left_nats) : 0.0;
}

bool explains_the_smaller_part(const GapAnalysis& analysis, const GapFigures& test) {
  constexpr double half = 0.5;
  if (analysis.check.passed || std::ranges::none_of(analysis.found, of_free_runs)) return false;
  const bool explains_little =
      share_of_evidence(analysis) < sure_posterior && largest_share_gone(test) < half;
  return explains_little || (goes_further_astray(test) && !some_is_beyond_doubt_untouched(analysis));
}

}  // namespace wheelwright::gap
