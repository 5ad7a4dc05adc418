// Which word an analysis comes to, and what it says.
#include "model/gap/conclusion/verdict.hpp"

#include <algorithm>

#include "model/gap/candidates/decoys.hpp"
#include "model/gap/conclusion/acceptance.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_findings.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

// `over_quick_noise`: in floors of the noise from reading to reading; by default as over that of seconds.
Verdict verdict_of(GapAnalysis analysis, double over_quick_noise = 0.0) {
  const Excess left = residual_excess(analysis);
  reach_verdict(analysis, {}, {{left.figure, std::max(left.times, over_quick_noise), left.closed}, {}});
  return analysis.verdict;
}

}  // namespace

TEST_CASE("A name stands from a probability of 0.9 on, and below it the answer is ambiguous") {
  CHECK(verdict_of(analysis_with({finding("backlash", 50.0, 0.95)}, position(3.0, 1.0))) == Verdict::named);
  CHECK(verdict_of(analysis_with({finding("backlash", 50.0, 0.95), finding("stiction", 50.0, 0.6)},
                                 position(3.0, 1.0))) == Verdict::ambiguous);
}

TEST_CASE("Where a decoy explains more than any name, the summary says what it does") {
  const auto summary_of = [](double nats) {
    GapAnalysis analysis = analysis_with({}, position(1.1, 1.1));
    Candidate& best = analysis.search.selection_steps.back().candidates.emplace_back();
    best.effect.info = &*std::ranges::find(decoys(), "decoy_swing", &EffectInfo::name);
    best.train_nats = best.heldout_nats = nats;
    reach_verdict(analysis, {}, {residual_excess(analysis), {}});
    return analysis.summary;
  };
  CHECK_THAT(summary_of(200.0), ContainsSubstring("it is as if the gain swung slowly with time."));
  CHECK_THAT(summary_of(5.0), !ContainsSubstring("as if"));
}

TEST_CASE("A figure of some millimetres is no gap, however far above its noise it lies") {
  auto figures = position(3.0, 3.0);
  for (Score* score : {&figures.before, &figures.after, &figures.floor}) score->position_rms_m->value *= 0.1;
  CHECK(verdict_of(analysis_with({}, figures)) == Verdict::nothing_missing);
}

TEST_CASE("Where nothing was found the figures say whether something is missing") {
  CHECK(verdict_of(analysis_with({}, position(1.1, 1.1))) == Verdict::nothing_missing);
  CHECK(verdict_of(analysis_with({}, position(1.8, 1.8))) == Verdict::unnamed);
}

TEST_CASE("From first to last pose alone a robot may have wandered half as far again as robots usually do") {
  auto figures = position(1.8, 1.8);
  for (Score* score : {&figures.before, &figures.after, &figures.floor}) {
    score->position_rms_m->horizon_s = 60.0;
  }
  CHECK(verdict_of(analysis_with({}, figures)) == Verdict::nothing_missing);
  figures.after.position_rms_m->value *= 1.5;
  CHECK(verdict_of(analysis_with({}, figures)) == Verdict::unnamed);
}

TEST_CASE("A wheel that was held more than once is something for which the library has no name") {
  auto analysis = analysis_with({}, position(1.0, 1.0));
  DataFault held;
  held.happened = true;
  analysis.data_faults.push_back(held);
  CHECK(verdict_of(analysis) == Verdict::nothing_missing);
  analysis.data_faults.push_back(held);
  CHECK(verdict_of(analysis) == Verdict::unnamed);
}

TEST_CASE("A loss in one direction at one heading may be friction as well as a slope") {
  const std::vector<Untestable> neither{{"floor_slope", "no turn"}, {"backlash", "no reversal"}};
  std::vector<Finding> found{finding("coulomb_friction", 500.0)};
  add_rivals_that_cannot_show(found, neither, 60.0);
  CHECK(found.front().rivals.front().effect == "floor_slope");
  CHECK(verdict_of(analysis_with(found, position(3.0, 1.0))) == Verdict::ambiguous);

  std::vector<Finding> with_reversals{finding("coulomb_friction", 500.0)};
  add_rivals_that_cannot_show(with_reversals, std::span(neither).first(1), 60.0);
  CHECK(with_reversals.front().rivals.empty());
}

TEST_CASE("A wheel that is late on starting and runs freely then may only have had play to take up") {
  const std::vector<Untestable> forward_only{{"backlash", "no reversal"}};
  std::vector<Finding> found{finding("stiction", 500.0), finding("stiction", 500.0)};
  found[0].setting.parameters = {0.1, 0.0, 0.1, 0.002};
  found[1].setting.parameters = {0.1, 0.03, 0.1, 0.002};
  add_rivals_that_cannot_show(found, forward_only, 60.0);
  CHECK(found[0].rivals.front().effect == "backlash");
  CHECK(found[1].rivals.empty());
}

TEST_CASE(
    "A gain that falls evenly may be the battery, of which the logs say nothing, and one that settles is "
    "not") {
  const std::vector<Untestable> no_voltage{{"voltage_sag", "no voltage"}};
  std::vector<Finding> found{finding("gain_drift", 500.0), finding("gain_drift", 500.0)};
  found[0].setting.parameters = {-0.2, 600.0};
  found[1].setting.parameters = {-0.2, 20.0};
  add_rivals_that_cannot_show(found, no_voltage, 60.0);
  CHECK(found[0].rivals.front().effect == "voltage_sag");
  CHECK(found[1].rivals.empty());
}

TEST_CASE("Noise that wanders for a while is no gap, unless free runs are far beyond it") {
  CHECK(verdict_of(analysis_with({}, position(1.1, 1.1)), 1.9) == Verdict::nothing_missing);
  CHECK(verdict_of(analysis_with({}, position(1.6, 1.6)), 1.9) == Verdict::unnamed);
  CHECK(verdict_of(analysis_with({}, position(1.1, 1.1)), 3.5) == Verdict::unnamed);
}

TEST_CASE("Held-out runs that are far off, where training is not, say that something changed") {
  auto analysis = analysis_with({}, position(1.0, 1.0));
  analysis.test = position(4.0, 4.0);
  CHECK(verdict_of(analysis) == Verdict::unnamed);
  analysis.tail_held_out = true;
  CHECK(verdict_of(analysis) == Verdict::nothing_missing);
}
