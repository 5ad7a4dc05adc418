#include "drivers/roomba/lateness_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/catch.hpp"

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using wheelwright::roomba::LatenessHistogram;

namespace {

double ns(nanoseconds duration) {
  return static_cast<double>(duration.count());
}

}  // namespace

TEST_CASE("A histogram without entries says zero") {
  const LatenessHistogram histogram;
  CHECK(histogram.count() == 0);
  CHECK(histogram.largest() == 0ns);
  CHECK(histogram.quantile(0.5) == 0ns);
  CHECK(histogram.quantile(1.0) == 0ns);
}

TEST_CASE("Every quantile of a single lateness is that lateness, to 4.2 per cent") {
  for (const nanoseconds lateness : {nanoseconds(100), nanoseconds(101), nanoseconds(12345), nanoseconds(1ms),
                                     nanoseconds(17'999'999), nanoseconds(1s), nanoseconds(59s)}) {
    LatenessHistogram histogram;
    histogram.add(lateness);
    for (const double share : {0.0, 0.01, 0.5, 0.999, 1.0}) {
      CHECK(histogram.quantile(share) <= lateness);
      CHECK(ns(histogram.quantile(share)) >= ns(lateness) / 1.042);
    }
  }
}

TEST_CASE("Quantiles agree with those of the sorted entries to 4.2 per cent") {
  std::mt19937_64 random(61);
  std::lognormal_distribution<double> lateness_ns(10.0, 1.5);
  LatenessHistogram histogram;
  std::vector<double> sorted;
  for (int i = 0; i < 100'000; ++i) {
    const auto lateness = nanoseconds(100 + static_cast<std::int64_t>(lateness_ns(random)));
    histogram.add(lateness);
    sorted.push_back(ns(lateness));
  }
  std::sort(sorted.begin(), sorted.end());
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 0.9999}) {
    const double exact = sorted.at(static_cast<std::size_t>(std::ceil(share * 100'000.0)) - 1);
    CHECK_THAT(ns(histogram.quantile(share)) / exact, WithinAbs(1.0, 0.042));
  }
  CHECK(ns(histogram.largest()) == sorted.back());
  CHECK(histogram.quantile(1.0) == histogram.largest());
}

TEST_CASE("Waking up early is not late, and what is beyond every bin is still the largest") {
  LatenessHistogram histogram;
  histogram.add(-5ms);
  CHECK(histogram.largest() == 0ns);
  CHECK(histogram.quantile(1.0) == 0ns);
  histogram.add(std::chrono::hours(1));
  CHECK(histogram.quantile(0.5) <= 100ns);
  CHECK(histogram.quantile(1.0) == std::chrono::hours(1));
}

TEST_CASE("Quantiles rise with the share") {
  LatenessHistogram histogram;
  for (int us = 1; us <= 10'000; ++us) histogram.add(std::chrono::microseconds(us));
  nanoseconds last = 0ns;
  for (double share = 0.0; share <= 1.0; share += 0.001) {
    CHECK(histogram.quantile(share) >= last);
    last = histogram.quantile(share);
  }
}

TEST_CASE("Steps for people double, hold every wake-up, and are no wider than what was seen") {
  LatenessHistogram histogram;
  for (const int microseconds : {3, 15, 16, 900}) histogram.add(std::chrono::microseconds(microseconds));
  const auto steps = coarse(histogram);
  REQUIRE_FALSE(steps.empty());
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    all += steps[i].count;
    if (i > 0) CHECK(std::abs((steps[i].upper_edge - 2 * steps[i - 1].upper_edge).count()) <= 2);
  }
  CHECK(all == 4);
  CHECK(steps.back().upper_edge >= std::chrono::microseconds(900));
  CHECK(steps.back().upper_edge < std::chrono::microseconds(1800));
  CHECK(coarse(LatenessHistogram()).empty());
}
