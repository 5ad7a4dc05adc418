// When what was found is an answer: rules on evidence and on what free runs show.
#include "model/gap/conclusion/acceptance.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/gap_findings.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

TEST_CASE("An effect closes the gap where a figure above the noise falls by it") {
  CHECK(closes_the_gap(analysis_with({finding("turn_scrub", 12.0)}, position(2.0, 1.5)), false));
  CHECK_FALSE(closes_the_gap(analysis_with({finding("turn_scrub", 12.0)}, position(2.0, 1.99)), false));
}

TEST_CASE(
    "A figure that falls within the noise may do so by chance, and then more has to speak for an effect") {
  CHECK_FALSE(closes_the_gap(analysis_with({finding("turn_scrub", 18.0)}, position(0.9, 0.8)), false));
  CHECK(closes_the_gap(analysis_with({finding("turn_scrub", 30.0)}, position(0.9, 0.8)), false));
  CHECK_FALSE(closes_the_gap(analysis_with({finding("turn_scrub", 90.0)}, position(0.9, 0.9)), false));
  CHECK(closes_the_gap(analysis_with({finding("turn_scrub", 120.0)}, position(0.9, 0.9)), false));
}

TEST_CASE("What is not sure, or explains no more than chance may, is not beyond chance") {
  CHECK_FALSE(is_beyond_chance(analysis_with({finding("caster_kick", 10.0)}, position(1.1, 0.9))));
  CHECK(is_beyond_chance(
      analysis_with({finding("caster_kick", 10.0), finding("turn_scrub", 40.0)}, position(1.1, 0.9))));
  Finding doubtful = finding("turn_scrub", 40.0);
  doubtful.posterior = 0.6;
  CHECK_FALSE(is_beyond_chance(analysis_with({doubtful}, position(1.1, 0.9))));
}

TEST_CASE("What makes a figure of free runs worse needs to be beyond doubt") {
  CHECK(closes_the_gap(analysis_with({finding("turn_speed_loss", 44.0)}, position(1.5, 1.5)), false));
  CHECK_FALSE(closes_the_gap(analysis_with({finding("turn_speed_loss", 44.0)}, position(1.5, 1.8)), false));
  CHECK(closes_the_gap(analysis_with({finding("turn_speed_loss", 144.0)}, position(1.5, 1.8)), false));
}

TEST_CASE("A delay alone has to show, however likely it is, since a larger core could be as good") {
  CHECK_FALSE(closes_the_gap(analysis_with({finding("transport_delay", 500.0)}, position(1.1, 0.9)), false));
  CHECK(closes_the_gap(analysis_with({finding("transport_delay", 500.0)}, position(2.0, 1.5)), false));
}

TEST_CASE(
    "Names that explain less than half of the gap in runs that fail the check are not what is missing") {
  const auto explains_less = [](const std::string& effect, double before, double after, bool passed) {
    GapAnalysis analysis = analysis_with({finding(effect, 400.0)}, position(before, after));
    analysis.check.passed = passed;
    return explains_the_smaller_part(analysis);
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
  CHECK_FALSE(explains_the_smaller_part(analysis));
}
