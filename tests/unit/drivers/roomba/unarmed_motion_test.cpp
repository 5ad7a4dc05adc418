#include "drivers/roomba/unarmed_motion.hpp"

#include "tests/support/catch.hpp"

using wheelwright::roomba::UnarmedMotion;

namespace {

constexpr double period_s = 0.018;

// How often motion begins while the wheels turn by so many ticks in each of `samples` samples.
int beginnings(UnarmedMotion& motion, bool armed, int samples, int ticks) {
  int count = 0;
  for (int i = 0; i < samples; ++i) count += motion.take(armed, ticks) ? 1 : 0;
  return count;
}

constexpr int ten_s = 556;

}  // namespace

TEST_CASE("An unarmed robot that begins to move is noticed once, and again after it has stood") {
  UnarmedMotion motion(period_s);
  CHECK(beginnings(motion, false, ten_s, 0) == 0);
  CHECK(beginnings(motion, false, ten_s, 5) == 1);
  CHECK(beginnings(motion, false, ten_s, 0) == 0);
  CHECK(beginnings(motion, false, ten_s, 5) == 1);
}

TEST_CASE("An armed robot may move, and brake after it was disarmed") {
  UnarmedMotion motion(period_s);
  CHECK(beginnings(motion, true, ten_s, 10) == 0);
  CHECK(beginnings(motion, false, 60, 10) == 0);
  CHECK(beginnings(motion, false, ten_s, 0) == 0);
}

TEST_CASE("A jolt of somebody who touches the robot is no motion") {
  UnarmedMotion motion(period_s);
  CHECK(beginnings(motion, false, ten_s, 0) == 0);
  CHECK(beginnings(motion, false, 5, 5) == 0);
  CHECK(beginnings(motion, false, ten_s, 0) == 0);
}
