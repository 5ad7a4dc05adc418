#include "model/gap/fit/trial_model.hpp"

#include <numeric>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

TrialModel some_core(bool shared) {
  CoreShape shape;
  shape.shared = shared;
  TrialModel model = first_guess(shape, 0.02, 0.25, 0.08, 0.04);
  for (std::size_t i = 0; i < model.core.size(); ++i) model.core[i] += 0.002 * static_cast<double>(1 + i % 5);
  return model;
}

// Wheel speeds after steps of both commands.
std::vector<double> answer(const TrialModel& model) {
  ModelSimulation simulation = model.simulation();
  simulation.reset({});
  std::vector<double> speeds;
  for (int k = 0; k < 200; ++k) {
    const WheelPair speed = simulation.step({k < 50 ? 0.2 : -0.1, k < 90 ? 0.1 : 0.3}).wheel_m_s;
    speeds.push_back(speed.left);
    speeds.push_back(speed.right);
  }
  return speeds;
}

void check_same(const std::vector<double>& one, const std::vector<double>& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) REQUIRE_THAT(one[i], WithinAbs(other[i], 1e-9));
}

}  // namespace

TEST_CASE("A richer core begins with the answer of the one that it came from") {
  const auto shared = GENERATE(false, true);
  const TrialModel core = some_core(shared);
  const TrialModel share = core.with_crossed_core(Crossing::share);
  CHECK(core.with_larger_core(0.98).shape.poles == core.shape.poles + 1);
  check_same(answer(core.with_larger_core()), answer(core));
  check_same(answer(core.with_larger_core(0.98)), answer(core));
  check_same(answer(share), answer(core));
  for (const Crossing crossing : {Crossing::balanced, Crossing::free}) {
    check_same(answer(core.with_crossed_core(crossing).with_larger_core(0.98)), answer(core));
  }
  if (!shared) return;
  CHECK(core.excess_of_right() != 0.0);
  TrialModel skewed = core.with_skewed_core();
  check_same(answer(skewed.with_larger_core(0.98)), answer(core));
  check_same(answer(core.with_parted_core()), answer(core));
  skewed.core.back() = 0.3;
  check_same(answer(skewed.with_parted_core().with_larger_core()), answer(skewed));
}

TEST_CASE("A core that is later answers as its own does behind a delay") {
  const Crossing crossing = GENERATE(Crossing::none, Crossing::share, Crossing::balanced, Crossing::free);
  const TrialModel core = some_core(false).with_crossed_core(crossing);
  const EffectInfo* info = find_effect("transport_delay");
  for (const double delay_s : {0.005, 0.04, 0.077}) {
    TrialModel behind_delay = core;
    behind_delay.effects = {{info, 0, {delay_s}}};
    check_same(answer(core.with_later_core(delay_s)), answer(behind_delay));
    check_same(answer(behind_delay.with_delay_in_core()), answer(behind_delay));
    CHECK(behind_delay.with_delay_in_core().effects.empty());
  }
}

TEST_CASE("A core that feels the other wheel by a share feels as much by weights of its own") {
  TrialModel share = some_core(false).with_crossed_core(Crossing::share);
  share.core[share.shape.per_wheel() - 1] = 0.03;
  share.core.back() = -0.02;
  CHECK(share.share_of_other_wheel() == 0.03);
  const TrialModel free = share.with_crossed_core(Crossing::free);
  CHECK(free.core.size() == share.core.size() + 2 * (share.shape.weights - 1));
  check_same(answer(free), answer(share));
  check_same(answer(free.with_larger_core(0.9)), answer(share));
}

TEST_CASE("A core whose crossing is balanced turns otherwise than it travels, by the same gain") {
  const auto shared = GENERATE(false, true);
  const TrialModel core = some_core(shared);
  TrialModel balanced = core.with_crossed_core(Crossing::balanced);
  balanced.core[core.shape.per_wheel()] = 0.05;
  balanced.core[core.shape.per_wheel() + 2] = -0.02;
  const LinearModel linear = balanced.linear();
  CHECK_THAT(dc_gain(linear.left).from_right, WithinAbs(0.0, 1e-12));
  CHECK_THAT(dc_gain(linear.left).from_left, WithinAbs(dc_gain(core.linear().left).from_left, 1e-12));
  CHECK(answer(balanced) != answer(core));
  check_same(answer(balanced.with_larger_core(0.9)), answer(balanced));
  check_same(answer(balanced.with_crossed_core(Crossing::free)), answer(balanced));
  if (!shared) return;
  TrialModel skewed = balanced.with_skewed_core();
  skewed.core.back() = 0.3;
  check_same(answer(skewed.with_parted_core()), answer(skewed));
}

TEST_CASE("A skewed core answers later with the right wheel by what it says, and further by its excess") {
  TrialModel skewed = some_core(true).with_skewed_core();
  skewed.core[skewed.shape.per_wheel()] = 0.02;
  skewed.core.back() = 0.5;
  const LinearModel core = skewed.linear();
  CHECK_THAT(dc_gain(core.left).from_left / 0.99, WithinAbs(dc_gain(core.right).from_right / 1.01, 1e-12));
  const auto mean_lag_periods = [](const std::vector<double>& weights) {
    double moment = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) moment += static_cast<double>(i) * weights[i];
    return moment / std::accumulate(weights.begin(), weights.end(), 0.0);
  };
  CHECK_THAT(mean_lag_periods(core.right.from_right) - mean_lag_periods(core.left.from_left),
             WithinAbs(0.5, 1e-9));
}

TEST_CASE("A start beyond what is possible is taken back to the bounds, which a simulation demands") {
  TrialModel model = some_core(true);
  const TrialEffect beyond{find_effect("wheel_eccentricity"), 0, {-1.0, 0.1, 2.0, 0.0, 0.2}};
  model.effects = {beyond.within_bounds()};
  CHECK(model.effects.front().parameters == std::vector<double>{-0.4, 0.1, 0.4, 0.0, 0.2});
  CHECK_NOTHROW(model.simulation());
}
