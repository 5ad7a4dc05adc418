#include "model/gap/conclusion/check_verdict.hpp"

#include "model/gap/conclusion/acceptance.hpp"
#include "model/gap/conclusion/withdrawal.hpp"

namespace wheelwright::gap {
namespace {

// " stiction and backlash".
std::string names_of(const GapAnalysis& analysis) {
  std::string names;
  for (const Finding& found : analysis.found) {
    if (found.setting.name != dropout_name) names += (names.empty() ? " " : " and ") + found.setting.name;
  }
  return names;
}

}  // namespace

void apply_check(GapAnalysis& analysis) {
  const PredictiveCheck& check = analysis.check;
  if (check.passed) return;
  const CheckStatistic& failed = check.statistics.front();
  const Regime regime{failed.regime, failed.share_of_gap, failed.share_of_time};
  if (analysis.verdict == Verdict::nothing_missing) {
    analysis.verdict = Verdict::unnamed;
    analysis.summary =
        "Something is missing that no effect of the library explains: " + failed.sentence + ".";
    analysis.where = {regime};
    return;
  }
  const bool has_names = !analysis.found.empty();
  analysis.summary += has_names ? " And something else: " : " The largest: ";
  analysis.summary += failed.sentence + ".";
  if (analysis.verdict == Verdict::unnamed && analysis.where.empty()) analysis.where = {regime};
}

std::string part_in_words(const GapAnalysis& analysis) {
  const double share = share_of_evidence(analysis);
  const std::string names = names_of(analysis);
  const int percent = static_cast<int>(100.0 * share);  // 89.7 is less than 90
  if (percent > 0 && share < sure_posterior)
    return names + " would explain " + std::to_string(percent) + " % of the evidence.";
  return " The other runs look like" + names + ", by which these come no closer.";
}

std::string unconfirmed_in_words(const std::vector<std::string>& names) {
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? " " : " and ") + name;
  return words + (names.size() == 1 ? " was" : " were") + " left out: the untouched runs do not confirm it.";
}

std::string not_seen_in_words(const GapAnalysis& analysis) {
  return " The other runs look like" + names_of(analysis) +
         ", which does not bring the free runs of these closer.";
}

}  // namespace wheelwright::gap
