#include "model/gap/candidates/steady_response.hpp"

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

SteadyResponse beside(const std::vector<TrialEffect>& effects) {
  TrialModel model = test::counted_robot();
  model.effects = effects;
  return {model, 0.4};
}

}  // namespace

TEST_CASE("A model without effects passes each held command on as it is") {
  const SteadyResponse response = beside({});
  for (const double command_m_s : {-0.4, -0.01, 0.0, 0.3}) {
    CHECK(response.at(command_m_s) == command_m_s);
    CHECK(response.slope(command_m_s) == 1.0);
  }
}

TEST_CASE("No change of a command is seen beyond a saturation, and all of it below") {
  const SteadyResponse response = beside({{find_effect("saturation"), 0, {0.2, 0.0, 0.0}}});
  for (const double sign : {-1.0, 1.0}) {
    CHECK_THAT(response.at(sign * 0.1), WithinAbs(sign * 0.1, 1e-6));
    CHECK_THAT(response.slope(sign * 0.1), WithinAbs(1.0, 1e-6));
    CHECK_THAT(response.at(sign * 0.35), WithinAbs(sign * 0.2, 1e-6));
    CHECK_THAT(response.slope(sign * 0.35), WithinAbs(0.0, 1e-6));
  }
}

TEST_CASE("No change of a command is seen inside a dead zone") {
  const SteadyResponse response = beside({{find_effect("dead_zone"), 0, {0.05, 1.0}}});
  CHECK_THAT(response.at(0.02), WithinAbs(0.0, 1e-9));
  CHECK_THAT(response.slope(0.02), WithinAbs(0.0, 1e-9));
  CHECK_THAT(response.slope(0.2), WithinAbs(1.0, 0.01));
}

TEST_CASE("A delay changes nothing of what a held command comes to") {
  const SteadyResponse response = beside({{find_effect("transport_delay"), 0, {2.5}}});
  CHECK_THAT(response.at(0.25), WithinAbs(0.25, 1e-6));
  CHECK_THAT(response.slope(0.25), WithinAbs(1.0, 1e-6));
}
