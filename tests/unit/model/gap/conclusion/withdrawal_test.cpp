// When the runs that nothing was chosen by contradict the names.
#include "model/gap/conclusion/withdrawal.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/gap_findings.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

TEST_CASE(
    "Names that explain less than half of the gap in runs that fail the check are not what is missing") {
  const auto explains_less = [](const std::string& effect, double before, double after, bool passed) {
    GapAnalysis analysis = analysis_with({finding(effect, 400.0)}, position(before, after));
    analysis.check.passed = passed;
    return explains_the_smaller_part(analysis, largest_share_gone(analysis.test));
  };
  CHECK(explains_less("gain_curve", 2.0, 1.6, false));
  CHECK_FALSE(explains_less("gain_curve", 2.0, 1.3, false));
  CHECK_FALSE(explains_less("gain_curve", 2.0, 1.6, true));
  CHECK_FALSE(explains_less("stiction", 2.0, 1.6, false));
  CHECK(explains_less("stiction", 2.0, 2.1, false));
}

TEST_CASE("A name by which no figure of the untouched runs falls by 3 % is not what is missing") {
  const auto closes_nothing = [](double before, double after, bool untouched, bool acts = true) {
    GapAnalysis analysis = analysis_with({finding("caster_kick", 400.0)}, position(before, after));
    analysis.found.front().acts_untouched = acts;
    analysis.untouched = untouched;
    return closes_nothing_untouched(analysis);
  };
  CHECK(closes_nothing(1.02, 1.0, true));
  CHECK(closes_nothing(1.0, 1.3, true));
  CHECK_FALSE(closes_nothing(1.2, 1.0, true));
  CHECK_FALSE(closes_nothing(1.0, 1.3, false));        // those chose it: other rules have looked at them
  CHECK_FALSE(closes_nothing(1.0, 1.0, true, false));  // it does nothing there
}

TEST_CASE("A figure that falls while the others rise as much does not keep a name that is not beyond doubt") {
  const auto closes_nothing = [](double nats, double position_after, double heading_after_rad) {
    GapAnalysis analysis = analysis_with({finding("caster_kick", nats)}, position(1.0, position_after));
    analysis.test.before.heading_rms_rad = AtHorizon{10.0, 0.010};
    analysis.test.after.heading_rms_rad = AtHorizon{10.0, heading_after_rad};
    analysis.found.front().acts_untouched = true;
    analysis.untouched = true;
    return closes_nothing_untouched(analysis);
  };
  CHECK(closes_nothing(40.0, 0.95, 0.0106));
  CHECK_FALSE(closes_nothing(400.0, 0.95, 0.0106));
  CHECK_FALSE(closes_nothing(40.0, 0.90, 0.0104));
}

TEST_CASE("Counts that stood still are named by the data, whatever free runs say") {
  GapAnalysis analysis = analysis_with({finding("encoder_dropout", 400.0)}, position(2.0, 2.0));
  analysis.check.passed = false;
  CHECK_FALSE(explains_the_smaller_part(analysis, 0.0));
}
