// When the runs that nothing was chosen by contradict the names.
#include "model/gap/conclusion/withdrawal.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/gap_findings.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

TEST_CASE("Names that explain little of the evidence and of free runs are not what is missing") {
  const auto explains_less = [](double gain_nats, double p_value, bool passed, double after = 1.6) {
    GapAnalysis analysis = analysis_with({finding("gain_curve", 400.0)}, position(2.0, after));
    analysis.names_gain_nats = gain_nats;
    analysis.check.p_value = p_value;
    analysis.check.passed = passed;
    return explains_the_smaller_part(analysis, analysis.test);
  };
  CHECK(explains_less(89.0, std::exp(-10.0), false));
  CHECK_FALSE(explains_less(91.0, std::exp(-10.0), false));
  CHECK(explains_less(-5.0, 0.001, false));
  CHECK(explains_less(1000.0, 0.0, false));  // smaller than any number
  CHECK_FALSE(explains_less(5.0, 0.5, true));
  CHECK_FALSE(explains_less(89.0, std::exp(-10.0), false, 1.3));  // more than half of the square is gone
}

TEST_CASE("Names by which free runs end further off in runs that fail the check are not what is missing") {
  const auto is_withdrawn = [](double before, double after, double test_nats = -10.0) {
    GapAnalysis analysis = analysis_with({finding("gain_curve", 400.0)}, position(before, after));
    analysis.untouched = true;
    analysis.found.front().acts_untouched = true;
    analysis.found.front().test_gain_nats = test_nats;
    analysis.names_gain_nats = 1000.0;
    analysis.check.p_value = 1e-4;
    analysis.check.passed = false;
    return explains_the_smaller_part(analysis, analysis.test);
  };
  CHECK(is_withdrawn(2.0, 2.1));
  CHECK(is_withdrawn(1.0, 1.6));
  CHECK_FALSE(is_withdrawn(1.0, 1.4));  // no further than noise goes
  CHECK_FALSE(is_withdrawn(2.0, 1.9));
  CHECK(is_withdrawn(2.0, 2.1, 90.0));
  CHECK_FALSE(is_withdrawn(2.0, 2.1, 3800.0));  // where a wheel comes loose that sticks, nobody predicts
}

TEST_CASE("A name by which no figure of the untouched runs falls by 3 % is not what is missing") {
  const auto closes_nothing = [](double before, double after, bool untouched, bool acts = true,
                                 double nats = 40.0, double test_nats = 400.0) {
    GapAnalysis analysis = analysis_with({finding("caster_kick", nats)}, position(before, after));
    analysis.found.front().acts_untouched = acts;
    analysis.found.front().test_gain_nats = test_nats;
    analysis.untouched = untouched;
    return closes_nothing_untouched(analysis);
  };
  CHECK(closes_nothing(1.02, 1.0, true));
  CHECK(closes_nothing(1.0, 1.3, true));
  CHECK_FALSE(closes_nothing(1.2, 1.0, true));
  CHECK_FALSE(closes_nothing(1.0, 1.3, false));        // those chose it: other rules have looked at them
  CHECK_FALSE(closes_nothing(1.0, 1.0, true, false));  // it does nothing there
  CHECK_FALSE(closes_nothing(1.02, 1.0, true, true, 400.0));  // a small wobble of a wheel, beyond doubt
  CHECK(closes_nothing(1.02, 1.0, true, true, 400.0, -10.0));
}

TEST_CASE("What the given model has already is not missing, however clearly the robot has it") {
  GapAnalysis analysis = analysis_with({finding("dead_zone", 400.0)}, position(1.0, 1.0));
  analysis.found.front().acts_untouched = true;
  analysis.found.front().test_gain_nats = 400.0;
  analysis.untouched = true;
  CHECK_FALSE(closes_nothing_untouched(analysis));
  analysis.before.effects.emplace_back().setting.name = "dead_zone";
  CHECK(closes_nothing_untouched(analysis));
}

TEST_CASE("A figure that falls while the others rise as much does not keep a name that is not beyond doubt") {
  const auto closes_nothing = [](double nats, double position_after, double heading_after_rad) {
    GapAnalysis analysis = analysis_with({finding("caster_kick", nats)}, position(1.0, position_after));
    analysis.test.before.heading_rms_rad = AtHorizon{10.0, 0.010};
    analysis.test.after.heading_rms_rad = AtHorizon{10.0, heading_after_rad};
    analysis.found.front().acts_untouched = true;
    analysis.found.front().test_gain_nats = nats;
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
  CHECK_FALSE(explains_the_smaller_part(analysis, analysis.test));
}

TEST_CASE("A name that untouched runs do not confirm is one, unless held-out runs put it beyond doubt") {
  const auto is_unconfirmed = [](double heldout_nats, double test_nats, bool acts = true,
                                 bool untouched = true) {
    GapAnalysis analysis =
        analysis_with({finding("turn_scrub", 800.0), finding("stiction", heldout_nats)}, position(2.0, 1.0));
    analysis.untouched = untouched;
    for (Finding& found : analysis.found) {
      found.acts_untouched = acts;
      found.test_gain_nats = 500.0;
    }
    analysis.found.back().test_gain_nats = test_nats;
    return unconfirmed_names(analysis) == std::vector<std::string>{"stiction"};
  };
  CHECK(is_unconfirmed(37.0, -25.0));
  CHECK(is_unconfirmed(37.0, 9.0));
  CHECK_FALSE(is_unconfirmed(37.0, 11.0));
  CHECK_FALSE(is_unconfirmed(3000.0, -25.0));
  CHECK_FALSE(is_unconfirmed(37.0, 0.0, false));  // it does nothing there
  CHECK_FALSE(is_unconfirmed(37.0, -25.0, true, false));
}
