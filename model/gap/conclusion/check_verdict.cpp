#include "model/gap/conclusion/check_verdict.hpp"

namespace wheelwright::gap {

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
  analysis.summary += has_names ? " And something else: " : " In the held-out runs, ";
  analysis.summary += failed.sentence + ".";
  if (analysis.verdict == Verdict::unnamed && analysis.where.empty()) analysis.where = {regime};
}

}  // namespace wheelwright::gap
