#include "daemon/telemetry/counted_notice.hpp"

#include "tests/support/catch.hpp"

using wheelwright::daemon::telemetry::CountedNotice;
using namespace std::chrono_literals;

TEST_CASE("What happens again and again is said at once, and then once a period with its number") {
  CountedNotice notice(5s);
  const CountedNotice::Clock::time_point start{};
  CHECK(notice.happened(start));
  CHECK_FALSE(notice.due(start + 20s));
  CHECK(notice.happened(start + 20s));
  int said = 0;
  std::uint64_t counted = 0;
  for (auto now = start + 20s; now < start + 40s; now += 1ms) {
    said += notice.happened(now) ? 1 : 0;
    if (const auto count = notice.due(now)) {
      ++said;
      counted += *count;
    }
  }
  CHECK(said == 3);  // after 25, 30 and 35 s
  const auto rest = notice.rest();
  REQUIRE(rest);
  CHECK(counted + *rest == 20000);
  CHECK_FALSE(notice.rest());
}

TEST_CASE("What happened in a period that nobody asked about is said together with what follows") {
  CountedNotice notice(5s);
  const CountedNotice::Clock::time_point start{};
  CHECK(notice.happened(start));
  CHECK_FALSE(notice.happened(start + 1s));
  CHECK_FALSE(notice.happened(start + 60s));
  CHECK(notice.due(start + 60s) == 2U);
}
