#include "model/gap/analysis.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

GapAnalysis analysed(const std::vector<DriveLog>& logs) {
  auto analysis = analyse_gap(std::span(logs).first(2), std::span(logs).last(1), {}, serial_for,
                              [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

GapAnalysis analysed(const std::string& hidden, test::Severity severity, double seconds) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.severity = severity;
  spec.channels = test::Channels::ticks;
  spec.runs = 3;
  spec.seconds = seconds;
  return analysed(test::make_gap_case(spec).runs);
}

}  // namespace

TEST_CASE("A delay that the linear part has taken for lag is given back to the delay") {
  const auto analysis = analysed("transport_delay", test::Severity::small, 25.0);
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "transport_delay");
}

TEST_CASE("Steps of the command are found though only the right step rounds the commands rightly") {
  const auto analysis = analysed("command_quantization", test::Severity::large, 25.0);
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "command_quantization");
  CHECK_THAT(analysis.found.front().setting.parameters[0], WithinRel(0.035, 0.01));
}

TEST_CASE(
    "Counts that were scaled by turning on a wheel base that is off are one effect, and turn as counted") {
  test::GapCaseSpec spec;
  spec.channels = test::Channels::ticks_ref;
  spec.runs = 3;
  spec.seconds = 50.0;
  spec.period_s = 0.03;
  auto logs = test::make_gap_case(spec).runs;
  for (DriveLog& log : logs) {
    log.wheel_base_m *= 0.97;
    log.metres_per_tick->left *= 0.97;
    log.metres_per_tick->right *= 0.97;
  }
  const auto analysis = analysed(logs);
  REQUIRE(analysis.verdict == Verdict::named);
  INFO(analysis.summary);
  REQUIRE(analysis.found.size() == 1);
  const EffectSetting& found = analysis.found.front().setting;
  CHECK(found.name == "distance_scale");
  CHECK(found.variant == "turns_as_counted");
  CHECK_THAT(found.parameters[0], WithinRel(1.0 / 0.97 - 1.0, 0.03));
}
