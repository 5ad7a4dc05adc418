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

TEST_CASE("Of free runs that are off by less than anybody sees, an effect has to be beyond chance") {
  const auto names = [](double nats, double before_m) {
    GapFigures figures = position(100.0 * before_m, 0.3);
    figures.floor.position_rms_m->value = 0.002;
    return closes_the_gap(analysis_with({finding("turn_speed_loss", nats)}, figures), false);
  };
  CHECK_FALSE(names(19.0, 0.005));
  CHECK(names(26.0, 0.005));
  CHECK(names(19.0, 0.007));
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

TEST_CASE("A delay alone has to show, however likely it is, where a linear part could hold it") {
  const auto names = [](double delay_s, double nats, double after) {
    Finding delay = finding("transport_delay", nats);
    delay.setting.parameters = {delay_s};
    return closes_the_gap(analysis_with({delay}, position(after < 1.0 ? 1.1 : 2.0, after)), false);
  };
  CHECK_FALSE(names(0.08, 500.0, 0.9));
  CHECK(names(0.08, 500.0, 1.5));
  CHECK(names(0.3, 500.0, 0.9));
  CHECK_FALSE(names(0.3, 50.0, 0.9));
}

TEST_CASE("A name whose size may be none is not given, one of a sure size, of several or of a limit is") {
  const auto sizeless = [](const std::string& name, const std::string& variant,
                           std::vector<ParameterInterval> intervals) {
    Finding found = finding(name, 500.0);
    found.setting.variant = variant;
    found.intervals = std::move(intervals);
    return names_without_size({&found, 1});
  };
  CHECK(sizeless("asymmetric_response", "speed", {{-0.0002, 0.0001}, {0.344, 0.351}}) ==
        std::vector<std::string>{"asymmetric_response"});
  CHECK(sizeless("asymmetric_response", "speed", {{0.02, 0.05}, {0.344, 0.351}}).empty());
  CHECK(sizeless("turn_scrub", "", {{0.0, 0.6}, {-1.0, 0.2}}).empty());
  CHECK(sizeless("saturation", "command", {{0.28, 0.32}, {0.0, 0.01}, {0.0, 0.02}}).empty());
  CHECK(sizeless("turn_speed_loss", "relative", {}).empty());
}
