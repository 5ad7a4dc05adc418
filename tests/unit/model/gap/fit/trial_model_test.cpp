#include "model/gap/fit/trial_model.hpp"

#include <numeric>

#include "model/effects/library/effect_library.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

TrialModel some_linear_part(bool shared) {
  LinearPartShape shape;
  shape.shared = shared;
  TrialModel model = first_guess(shape, 0.02, 0.25, 0.08, 0.04);
  for (std::size_t i = 0; i < model.linear_part.size(); ++i)
    model.linear_part[i] += 0.002 * static_cast<double>(1 + i % 5);
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

// Of the wheels, until they go steadily under a command.
WheelPair travel(const TrialModel& model, const WheelPair& command_m_s) {
  ModelSimulation simulation = model.simulation();
  simulation.reset({});
  WheelPair sum_m;
  for (int k = 0; k < 500; ++k) {
    const WheelPair speed = simulation.step(command_m_s).wheel_m_s;
    sum_m.left += speed.left * model.period_s;
    sum_m.right += speed.right * model.period_s;
  }
  return sum_m;
}

void check_same(const std::vector<double>& one, const std::vector<double>& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) REQUIRE_THAT(one[i], WithinAbs(other[i], 1e-9));
}

}  // namespace

TEST_CASE("A richer core begins with the answer of the one that it came from") {
  const auto shared = GENERATE(false, true);
  const TrialModel linear_part = some_linear_part(shared);
  const TrialModel share = linear_part.with_cross_coupling(CrossCoupling::share);
  CHECK(linear_part.with_higher_order(0.98).shape.poles == linear_part.shape.poles + 1);
  check_same(answer(linear_part.with_higher_order()), answer(linear_part));
  check_same(answer(linear_part.with_higher_order(0.98)), answer(linear_part));
  check_same(answer(share), answer(linear_part));
  for (const CrossCoupling cross_coupling : {CrossCoupling::balanced, CrossCoupling::free}) {
    check_same(answer(linear_part.with_cross_coupling(cross_coupling).with_higher_order(0.98)),
               answer(linear_part));
  }
  if (!shared) return;
  CHECK(linear_part.excess_of_right() != 0.0);
  TrialModel unequal_lags = linear_part.with_unequal_lags();
  check_same(answer(unequal_lags.with_higher_order(0.98)), answer(linear_part));
  check_same(answer(linear_part.with_parted_linear_part()), answer(linear_part));
  unequal_lags.linear_part.back() = 0.3;
  check_same(answer(unequal_lags.with_parted_linear_part().with_higher_order()), answer(unequal_lags));
}

TEST_CASE("A core that is later answers as its own does behind a delay") {
  const CrossCoupling cross_coupling = GENERATE(CrossCoupling::none, CrossCoupling::share, CrossCoupling::lag,
                                                CrossCoupling::balanced, CrossCoupling::free);
  const TrialModel linear_part = some_linear_part(false).with_cross_coupling(cross_coupling);
  const EffectInfo* info = find_effect("transport_delay");
  for (const double delay_s : {0.005, 0.04, 0.077}) {
    TrialModel behind_delay = linear_part;
    behind_delay.effects = {{info, 0, {delay_s}}};
    check_same(answer(linear_part.with_later_linear_part(delay_s)), answer(behind_delay));
    check_same(answer(behind_delay.with_delay_in_linear_part()), answer(behind_delay));
    CHECK(behind_delay.with_delay_in_linear_part().effects.empty());
  }
}

TEST_CASE("A core that feels the other wheel by a share feels as much by weights of its own") {
  TrialModel share = some_linear_part(false).with_cross_coupling(CrossCoupling::share);
  share.linear_part[share.shape.per_wheel() - 1] = 0.03;
  share.linear_part.back() = -0.02;
  const TrialModel free = share.with_cross_coupling(CrossCoupling::free);
  CHECK(free.linear_part.size() == share.linear_part.size() + 2 * (share.shape.weights - 1));
  check_same(answer(free), answer(share));
  check_same(answer(free.with_higher_order(0.9)), answer(share));
}

TEST_CASE(
    "A core that turns later than it travels has the same gain for both, and keeps the lag in any shape") {
  const auto shared = GENERATE(false, true);
  constexpr double periods = 0.4;
  const TrialModel linear_part = some_linear_part(shared);
  TrialModel lag = linear_part.with_cross_coupling(CrossCoupling::lag);
  check_same(answer(lag), answer(linear_part));
  lag.linear_part[lag.shape.per_wheel() - 1] = periods;
  if (!shared) lag.linear_part.back() = periods;
  const auto later_by = [&](double right_m_s) {
    const WheelPair command{0.2, right_m_s};
    return travel(linear_part, command).left - travel(lag, command).left;
  };
  const double gain = dc_gain(linear_part.linear().left).from_left;
  const double period_m = 0.2 * gain * linear_part.period_s;
  CHECK_THAT(later_by(0.2), WithinAbs(-periods * period_m, 1e-9));
  CHECK_THAT(later_by(-0.2), WithinAbs(periods * period_m, 1e-9));
  check_same(answer(lag.with_higher_order(0.9)), answer(lag));
  if (shared) check_same(answer(lag.with_parted_linear_part()), answer(lag));
  CHECK(lag.with_parted_linear_part().shape.weights == lag.shape.weights);
}

TEST_CASE("A core whose crossing is balanced turns otherwise than it travels, by the same gain") {
  const auto shared = GENERATE(false, true);
  const TrialModel linear_part = some_linear_part(shared);
  TrialModel balanced = linear_part.with_cross_coupling(CrossCoupling::balanced);
  balanced.linear_part[linear_part.shape.per_wheel()] = 0.05;
  balanced.linear_part[linear_part.shape.per_wheel() + 2] = -0.02;
  const LinearModel linear = balanced.linear();
  CHECK_THAT(dc_gain(linear.left).from_right, WithinAbs(0.0, 1e-12));
  CHECK_THAT(dc_gain(linear.left).from_left, WithinAbs(dc_gain(linear_part.linear().left).from_left, 1e-12));
  CHECK(answer(balanced) != answer(linear_part));
  check_same(answer(balanced.with_higher_order(0.9)), answer(balanced));
  check_same(answer(balanced.with_cross_coupling(CrossCoupling::free)), answer(balanced));
  if (!shared) return;
  TrialModel unequal_lags = balanced.with_unequal_lags();
  unequal_lags.linear_part.back() = 0.3;
  check_same(answer(unequal_lags.with_parted_linear_part()), answer(unequal_lags));
}

TEST_CASE(
    "A linear part of two modes turns by poles of its own, travels as before, and keeps both in any shape") {
  const auto shared = GENERATE(false, true);
  const auto cross_coupling = GENERATE(CrossCoupling::modes, CrossCoupling::balanced_modes);
  const TrialModel linear_part = some_linear_part(shared);
  const LinearPartShape& shape = linear_part.shape;
  TrialModel modes = linear_part.with_cross_coupling(cross_coupling);
  check_same(answer(modes), answer(linear_part));
  for (std::size_t wheel = 0; wheel < modes.shape.of_responses(); wheel += modes.shape.per_wheel())
    modes.linear_part[wheel + shape.poles + shape.weights] -= 0.1;  // a pole of turns
  CHECK_THAT(travel(modes, {0.2, 0.2}).left, WithinAbs(travel(linear_part, {0.2, 0.2}).left, 1e-9));
  const double turned_m = travel(modes, {0.2, -0.2}).left;
  CHECK(std::abs(turned_m - travel(linear_part, {0.2, -0.2}).left) > 1e-3);
  if (cross_coupling == CrossCoupling::balanced_modes)
    CHECK_THAT(dc_gain(modes.linear().left).from_right, WithinAbs(0.0, 1e-12));
  check_same(answer(modes.with_higher_order(0.9)), answer(modes));
  const EffectInfo* delay = find_effect("transport_delay");
  TrialModel behind_delay = modes;
  behind_delay.effects = {{delay, 0, {0.04}}};
  check_same(answer(modes.with_later_linear_part(0.04)), answer(behind_delay));
  if (!shared) return;
  TrialModel unequal_lags = modes.with_unequal_lags();
  unequal_lags.linear_part.back() = 0.3;
  check_same(answer(unequal_lags.with_parted_linear_part()), answer(unequal_lags));
}

TEST_CASE("Both wheels take the response of one") {
  const TrialModel linear_part = some_linear_part(false);
  for (const WheelSide wheel : {WheelSide::left, WheelSide::right}) {
    const LinearModel alike = linear_part.with_response_of(wheel).linear();
    CHECK(alike.left.from_left == alike.right.from_right);
    const LinearModel of_both = linear_part.linear();
    CHECK(alike.left.from_left ==
          (wheel == WheelSide::left ? of_both.left.from_left : of_both.right.from_right));
  }
}

TEST_CASE("Wheels alike that feel each other answer the same as a linear part of two modes") {
  TrialModel free = some_linear_part(true).with_cross_coupling(CrossCoupling::free);
  free.linear_part[free.shape.poles + free.shape.weights + 1] = 0.04;
  free.linear_part[free.shape.per_wheel()] = 0.0;  // no excess of the right wheel
  check_same(answer(free.with_cross_coupling(CrossCoupling::modes)), answer(free));
}

TEST_CASE("A skewed core answers later with the right wheel by what it says, and further by its excess") {
  TrialModel unequal_lags = some_linear_part(true).with_unequal_lags();
  unequal_lags.linear_part[unequal_lags.shape.per_wheel()] = 0.02;
  unequal_lags.linear_part.back() = 0.5;
  const LinearModel linear_part = unequal_lags.linear();
  CHECK_THAT(dc_gain(linear_part.left).from_left / 0.99,
             WithinAbs(dc_gain(linear_part.right).from_right / 1.01, 1e-12));
  const auto mean_lag_periods = [](const std::vector<double>& weights) {
    double moment = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) moment += static_cast<double>(i) * weights[i];
    return moment / std::accumulate(weights.begin(), weights.end(), 0.0);
  };
  CHECK_THAT(mean_lag_periods(linear_part.right.from_right) - mean_lag_periods(linear_part.left.from_left),
             WithinAbs(0.5, 1e-9));
}

TEST_CASE("A start beyond what is possible is taken back to the bounds, which a simulation demands") {
  TrialModel model = some_linear_part(true);
  const TrialEffect beyond{find_effect("wheel_eccentricity"), 0, {-1.0, 0.1, 2.0, 0.0, 0.2}};
  model.effects = {beyond.within_bounds()};
  CHECK(model.effects.front().parameters == std::vector<double>{-0.4, 0.1, 0.4, 0.0, 0.2});
  CHECK_NOTHROW(model.simulation());
}
