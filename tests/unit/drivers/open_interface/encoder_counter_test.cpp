#include "drivers/open_interface/encoder_counter.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

using namespace wheelwright::open_interface;

namespace {

constexpr int any_change = 30000;

std::uint16_t raw(std::int64_t count) {
  return static_cast<std::uint16_t>(count);
}

}  // namespace

TEST_CASE("The first count is the origin, wherever it is") {
  for (const int start : {0, 1, 32767, 32768, 65535}) {
    EncoderCounter counter;
    CHECK(counter.update(raw(start), 1.0, 50));
    CHECK(counter.total() == 0);
  }
}

TEST_CASE("Counts that roll over forwards and backwards lose nothing") {
  Random random(31);
  for (int walk = 0; walk < 200; ++walk) {
    EncoderCounter counter;
    std::int64_t count = between(random, 0, 65535);
    const int direction = walk % 2 == 0 ? 1 : -1;
    counter.update(raw(count), direction, any_change);
    const std::int64_t start = count;
    for (int i = 0; i < 1000; ++i) {
      count += direction * between(random, 0, i % 10 == 0 ? any_change : 20);
      REQUIRE(counter.update(raw(count), direction, any_change));
      REQUIRE(counter.total() == count - start);
    }
  }
}

TEST_CASE("The steps at which another driver jumps by 29 metres are small here") {
  const auto travel = [](int from, int to, double command) {
    EncoderCounter counter;
    counter.update(raw(from), command, any_change);
    counter.update(raw(to), command, any_change);
    return counter.total();
  };
  CHECK(travel(65533, 3, 0.1) == 6);
  CHECK(travel(3, 65533, -0.1) == -6);
  CHECK(travel(0, 65535, -0.1) == -1);
  CHECK(travel(32767, 32768, 0.1) == 1);
  CHECK(travel(32768, 32767, -0.1) == -1);
}

TEST_CASE("Back and forth with rests in between ends where it began, for whatever kind of encoder") {
  Random random(32);
  EncoderCounter counter;
  std::int64_t count = 65500;
  std::int64_t true_total = 0;
  counter.update(raw(count), 0.0, any_change);
  for (int i = 0; i < 300; ++i) {
    const int direction = between(random, 0, 1) == 0 ? -1 : 1;
    for (int k = 0; k < 5; ++k) counter.update(raw(count), direction, any_change);
    for (int k = 0; k < 40; ++k) {
      const int step = between(random, 5, 12);
      count += direction * step;
      true_total += direction * step;
      counter.update(raw(count), direction, any_change);
    }
    for (int k = 0; k < 5; ++k) counter.update(raw(count), 0.0, any_change);
    REQUIRE(counter.total() == true_total);
  }
}

TEST_CASE("A change that no wheel can make is not taken, and the next sound count goes on from before") {
  EncoderCounter counter;
  counter.update(1000, 1.0, 50);
  CHECK(counter.update(1040, 1.0, 50));
  CHECK(!counter.update(1091, 1.0, 50));
  CHECK(!counter.update(60000, 1.0, 50));
  CHECK(counter.total() == 40);
  CHECK(counter.update(1060, 1.0, 50));
  CHECK(counter.total() == 60);
}

TEST_CASE("With a new origin the total goes on without a jump") {
  EncoderCounter counter;
  counter.update(100, 1.0, 50);
  counter.update(140, 1.0, 50);
  counter.rebase();
  CHECK(counter.update(9, 1.0, 50));
  CHECK(counter.total() == 40);
  CHECK(counter.update(19, 1.0, 50));
  CHECK(counter.total() == 50);
}

TEST_CASE("A wheel that stands is never doubtful for long, whatever is commanded") {
  EncoderCounter counter;
  Random random(33);
  for (int i = 0; i < 1000; ++i) {
    counter.update(500, between(random, -1, 1), 50);
    REQUIRE(counter.total() == 0);
  }
  for (int i = 0; i < 13; ++i) counter.update(500, 0.0, 50);
  CHECK(!counter.doubtful());
}
