#include "daemon/silence_text.hpp"

#include "tests/support/catch.hpp"

using wheelwright::daemon::explain;
using wheelwright::daemon::SilenceContext;
using wheelwright::roomba::Silence;
using wheelwright::roomba::SilenceWatch;
using namespace std::chrono_literals;

namespace {

constexpr SilenceContext quiet{0.018, {0.3, 2}};
constexpr SilenceContext busy{0.018, {3.4, 2}};

}  // namespace

TEST_CASE("A silence in which the loop itself was late is the machine's, with how late and what to do") {
  Silence silence;
  silence.skipped_periods = 14;
  silence.largest_lateness = 252ms;
  silence.replies.missing = 1;
  const std::string text = explain(silence, quiet);
  CHECK_THAT(text, ContainsSubstring("the machine was too busy"));
  CHECK_THAT(text, ContainsSubstring("252.0 ms late and skipped 14 periods"));
  CHECK_THAT(text, ContainsSubstring("end other programs"));
}

TEST_CASE("A silence without a byte while the loop was in time is the cable's or the robot's") {
  Silence silence;
  silence.largest_lateness = 80us;
  silence.replies.missing = 13;
  const std::string text = explain(silence, quiet);
  CHECK_THAT(text,
             ContainsSubstring("nothing sound came from the robot (the loop woke up at most 0.1 ms late"));
  CHECK_THAT(text, ContainsSubstring("plugged in"));
}

TEST_CASE("A silence of damaged replies on a machine in time is the cable's, and they are counted") {
  Silence silence;
  silence.replies.incomplete = 4;
  silence.replies.garbled = 9;
  CHECK_THAT(explain(silence, quiet),
             ContainsSubstring("of 13 replies 0 did not come, 4 were incomplete or late, "
                               "9 were damaged while the machine was in time"));
}

TEST_CASE("A silence on a busy machine whose loop was in time names both, the machine first") {
  Silence silence;
  silence.replies.incomplete = 13;
  const std::string text = explain(silence, busy);
  CHECK_THAT(text, ContainsSubstring("load 3.4 on 2 cores"));
  REQUIRE_THAT(text, ContainsSubstring("look at the cable"));
  CHECK(text.find("end other programs") < text.find("look at the cable"));
}

TEST_CASE("A silence with sound replies is blamed on the counts in them") {
  Silence silence;
  silence.replies.sound = 13;
  CHECK_THAT(explain(silence, busy), ContainsSubstring("encoder counts that no wheel can have made"));
}

TEST_CASE("A silence counts from the last sound reading on") {
  SilenceWatch watch;
  watch.woke_up(40ms);
  watch.received(2, {.asked = 100, .sound = 97, .missing = 1, .incomplete = 1, .garbled = 1});
  watch.woke_up(3ms);
  watch.woke_up(1ms);
  const Silence silence =
      watch.until(3, {.asked = 114, .sound = 97, .missing = 12, .incomplete = 2, .garbled = 1});
  CHECK(silence.largest_lateness == 3ms);
  CHECK(silence.skipped_periods == 1);
  CHECK(silence.replies.missing == 11);
  CHECK(silence.replies.incomplete == 1);
  CHECK(silence.replies.garbled == 0);
}
