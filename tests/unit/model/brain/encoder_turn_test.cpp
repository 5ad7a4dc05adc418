#include <cmath>
#include <optional>
#include <vector>

#include "model/brain/manoeuvre.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

constexpr double period_s = 0.018;

struct Turned {
  std::vector<WheelOrder> orders;
  WheelTicks furthest;
  WheelTicks end;
};

// A robot that does at once as it is told, `counts_per_m` to a metre.
Turned turned(const EncoderTurnPlan& plan, double counts_per_m) {
  const auto manoeuvre = make_encoder_turn(plan, period_s);
  manoeuvre->restart();
  Turned result;
  SensorFrame frame;
  frame.valid = true;
  WheelPair travel_m;
  while (const auto order = manoeuvre->next(frame)) {
    result.orders.push_back(*order);
    travel_m.left += period_s * order->speed_m_s.left;
    travel_m.right += period_s * order->speed_m_s.right;
    ++frame.tick;
    frame.ticks = {std::llround(counts_per_m * travel_m.left), std::llround(counts_per_m * travel_m.right)};
    if (frame.ticks.right > result.furthest.right) result.furthest = frame.ticks;
  }
  result.end = frame.ticks;
  return result;
}

}  // namespace

TEST_CASE("For the encoder scale the robot turns one way and as far back") {
  const Turned turn = turned(EncoderTurnPlan{}, 2249.0);
  CHECK_THAT(static_cast<double>(turn.furthest.right), WithinAbs(2.0 * 1660.0, 10.0));
  CHECK_THAT(static_cast<double>(turn.furthest.left), WithinAbs(-2.0 * 1660.0, 10.0));
  CHECK_THAT(static_cast<double>(turn.end.right), WithinAbs(0.0, 20.0));
}

TEST_CASE("Before it turns back the robot stands for a while") {
  const Turned turn = turned(EncoderTurnPlan{}, 2249.0);
  double standing_s = 0.0;
  for (const WheelOrder& order : turn.orders)
    if (order.speed_m_s.left == 0.0) standing_s += period_s;
  CHECK(standing_s > 0.25);
  CHECK(turn.orders.front().speed_m_s.right > 0.0);
  CHECK(turn.orders.back().speed_m_s.right < 0.0);
}

TEST_CASE("A robot that does not count does not turn for ever") {
  const Turned turn = turned(EncoderTurnPlan{}, 0.0);
  CHECK(static_cast<double>(turn.orders.size()) * period_s < 70.0);
}
