#include "drivers/roomba/stream_clock.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::roomba;

TEST_CASE("The period of a stream is measured over damaged frames as well") {
  constexpr double period_s = 0.015625;
  StreamClock clock;
  double t_s = 3.0;
  std::int64_t made_up_for = 0;
  for (int k = 0; k < 400 && !clock.period_s(); ++k) {
    const std::int64_t damaged = k % 20 == 19 ? 2 : 0;
    t_s += static_cast<double>(1 + damaged) * period_s;
    made_up_for += clock.frame(t_s, damaged);
  }
  REQUIRE(clock.period_s());
  CHECK_THAT(*clock.period_s(), WithinAbs(period_s, 1e-9));
  CHECK(made_up_for > 10);
}

TEST_CASE("A period in which silence was noticed is not made up for once more") {
  StreamClock clock;
  clock.frame(0.0, 0);
  clock.silence();
  CHECK(clock.frame(0.045, 2) == 1);
  CHECK(clock.frame(0.060, 0) == 0);
  clock.silence();
  clock.silence();
  CHECK(clock.frame(0.105, 1) == 0);
  CHECK(clock.frame(0.135, 1) == 1);
}

TEST_CASE("A stream at 15 ms is another than one of 18 ms, and the same as one of 15.6 ms") {
  CHECK(is_another_period(0.015, 0.018));
  CHECK(is_another_period(0.018, 0.015));
  CHECK_FALSE(is_another_period(0.015, 0.015625));
}
