// When what was found is an answer: rules on evidence and on what free runs show.
#include "model/gap/gap_standing.hpp"

#include "model/gap/decoys.hpp"
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

TEST_CASE("What explains little is no answer where free runs stay far off, what explains a lot may be one") {
  CHECK(leaves_most_of_it(analysis_with({finding("floor_slope", 30.0)}, position(8.0, 7.0))));
  CHECK_FALSE(leaves_most_of_it(analysis_with({finding("floor_slope", 300.0)}, position(8.0, 7.0))));
  CHECK_FALSE(leaves_most_of_it(analysis_with({finding("floor_slope", 30.0)}, position(8.0, 1.2))));
}

TEST_CASE("What drives free runs apart in training and held-out runs is no answer, however likely it is") {
  const auto likely = finding("gain_curve", 4000.0);
  CHECK(drives_runs_apart(analysis_with({likely}, position(2.0, 3.5))));
  CHECK_FALSE(drives_runs_apart(analysis_with({likely}, position(2.0, 2.5))));
  GapAnalysis held_out_only = analysis_with({likely}, position(2.0, 1.0));
  held_out_only.test = position(2.0, 3.5);
  CHECK_FALSE(drives_runs_apart(held_out_only));
}

TEST_CASE("A smooth effect is no answer where more than it explains is left and hangs together") {
  const auto deflated_by = [](const std::string& effect, double inflation) {
    Finding found = finding(effect, 400.0);
    found.inflation = inflation;
    return found;
  };
  const Wandering calm{0.004, 0.009};
  CHECK(is_the_smaller_part(analysis_with({deflated_by("gain_curve", 27.0)}, position(2.0, 1.6)), calm));
  CHECK_FALSE(
      is_the_smaller_part(analysis_with({deflated_by("gain_curve", 27.0)}, position(2.0, 1.3)), calm));
  CHECK_FALSE(is_the_smaller_part(analysis_with({deflated_by("gain_curve", 2.0)}, position(2.0, 1.6)), calm));
  CHECK_FALSE(is_the_smaller_part(analysis_with({deflated_by("stiction", 27.0)}, position(2.0, 1.6)), calm));
  CHECK_FALSE(is_the_smaller_part(
      analysis_with({deflated_by("gain_curve", 27.0), deflated_by("yaw_bias", 2.0)}, position(2.0, 1.6)),
      calm));
  Finding little = deflated_by("caster_kick", 27.0);
  CHECK_FALSE(is_the_smaller_part(
      analysis_with({deflated_by("gain_curve", 27.0), little}, position(2.0, 1.6)), calm));
  little.heldout_gain_nats = 30.0;
  CHECK(is_the_smaller_part(analysis_with({deflated_by("gain_curve", 27.0), little}, position(2.0, 1.6)),
                            calm));
  const Wandering far{0.02, 0.009};
  CHECK(is_the_smaller_part(analysis_with({deflated_by("gain_curve", 27.0)}, position(2.0, 1.3)), far));
  CHECK_FALSE(is_the_smaller_part(analysis_with({deflated_by("gain_curve", 2.0)}, position(2.0, 1.3)), far));
}

TEST_CASE("A single effect without a rival stands unless free runs stay nowhere near the measured ones") {
  const auto alone = finding("floor_slope", 30.0, 1.0, 0.1);
  const auto rivalled = finding("floor_slope", 30.0, 1.0, 0.9);
  CHECK_FALSE(leaves_most_of_it(analysis_with({alone}, position(4.0, 3.0))));
  CHECK(leaves_most_of_it(analysis_with({rivalled}, position(4.0, 3.0))));
  CHECK(leaves_most_of_it(analysis_with({alone}, position(8.0, 7.0))));
}

TEST_CASE("A name beside which a decoy explains more than the name does is a shape of something else") {
  const auto contender = [](const EffectInfo& info, double score) {
    Contender result;
    result.effect.info = &info;
    result.score = score;
    return result;
  };
  const auto decoy_beside = [&](double score) {
    auto analysis = analysis_with({finding("gain_curve", 36.0)}, position(8.0, 5.0));
    const auto& effects = analysis.search.final.model.effects;
    analysis.search.rounds.back().without.model.effects = effects;
    analysis.search.rounds.back().contenders = {contender(decoys().front(), score)};
    analysis.search.checks.emplace_back();
    analysis.search.checks.back().contenders = {contender(*effects.front().info, 90.0)};
    return analysis;
  };
  CHECK(is_less_than_a_decoy_adds(decoy_beside(120.0)));
  CHECK_FALSE(is_less_than_a_decoy_adds(decoy_beside(80.0)));
  auto looked_at_before = decoy_beside(120.0);
  looked_at_before.search.rounds.back().without.model.effects.clear();
  CHECK_FALSE(is_less_than_a_decoy_adds(looked_at_before));
}
