// The cable loses, damages and delays what the robot sends: each reply that suffers is counted and costs at
// most its own sample.
#include <cmath>
#include <cstdlib>
#include <optional>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

// Counts that the daemon has added up are the way that the wheels truly went.
void check_counts_are_the_travel(const Table& log, const Table& truth) {
  std::size_t last = log.rows() - 1;
  while (log.empty(last, "ticks_left")) --last;
  const Travel travel = travel_of(truth);
  const double left_m = std::stod(truth.metadata("metres_per_tick_left")) * log.number(last, "ticks_left");
  const double right_m = std::stod(truth.metadata("metres_per_tick_right")) * log.number(last, "ticks_right");
  CHECK_THAT(left_m, WithinAbs(travel.left_m, 0.002));
  CHECK_THAT(right_m, WithinAbs(travel.right_m, 0.002));
}

// At constant speed a sample that was taken for that of its neighbour is a whole period's travel off.
void check_no_sample_is_shifted(const Table& log, double from_s, double to_s) {
  std::vector<std::size_t> sampled;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double t_s = log.number(row, "t");
    if (t_s >= from_s && t_s <= to_s && !log.empty(row, "ticks_left")) sampled.push_back(row);
  }
  REQUIRE(sampled.size() > 10);
  const auto time = [&](std::size_t row) { return log.number(row, "t"); };
  const auto ticks = [&](std::size_t row) { return log.number(row, "ticks_left"); };
  const std::size_t first = sampled.front();
  const std::size_t last = sampled.back();
  const double ticks_per_s = (ticks(last) - ticks(first)) / (time(last) - time(first));
  const double period_ticks = 0.018 * ticks_per_s;
  std::size_t shifted = 0;
  for (const std::size_t row : sampled) {
    const double expected = ticks(first) + ticks_per_s * (time(row) - time(first));
    if (std::abs(ticks(row) - expected) > 0.7 * period_ticks) ++shifted;
  }
  CHECK(shifted <= 3);  // a busy machine that asks late gets a later answer
}

// A log's row has a sample or has none; and the counts of replies say of how many rows it has none.
int rows_without_sample(const Table& log) {
  int count = 0;
  for (std::size_t row = 0; row < log.rows(); ++row) count += log.empty(row, "ticks_left") ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("Counters that roll over in mid-run, up and down, do not show in the log") {
  Bench bench;
  const auto robot =
      bench.start_robot("perfect", "encoder: { start_count_left: 200, start_count_right: 65400 }\n");
  // First a turn to the left, in which the left wheel goes back.
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0, 0.2]]"}));
  CHECK(daemon->wait(20s) == 0);
  robot->end();
  const Table log = bench.drive_log();
  double lowest = 0.0;
  std::optional<std::size_t> last;  // a busy machine may cost a row its reply
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (log.empty(row, "ticks_left")) continue;
    lowest = std::min(lowest, log.number(row, "ticks_left"));
    if (last) {
      // A robot that a busy machine held up goes further in one row, but not by a part of a roll-over.
      constexpr double most = 2000.0;
      CHECK(std::abs(log.number(row, "ticks_left") - log.number(*last, "ticks_left")) < most);
      CHECK(std::abs(log.number(row, "ticks_right") - log.number(*last, "ticks_right")) < most);
    }
    last = row;
  }
  REQUIRE(last);
  CHECK(lowest < -200.0);
  CHECK(log.number(*last, "ticks_right") > 136.0);
  check_counts_are_the_travel(log, bench.truth());
}

TEST_CASE("Lost bytes are counted and cost only their own samples") {
  Bench bench;
  const auto robot = bench.start_robot("perfect", "link:\n  to_host: { loss_probability: 0.004 }\n");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0.4, 0]]"}));
  CHECK(daemon->wait(20s) == 0);
  robot->end();
  const Replies replies = replies_of(daemon->out());
  const int bad = replies.missing + replies.incomplete + replies.garbled;
  CHECK(bad > 10);
  CHECK(std::abs(replies.asked - replies.sound - bad) <= 1);
  const Table log = bench.drive_log();
  CHECK(rows_without_sample(log) > 5);
  check_no_sample_is_shifted(log, 1.2, 2.2);
  check_counts_are_the_travel(log, bench.truth());
}

TEST_CASE("Garbled replies are counted and cost only their own samples") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon = bench.start_daemon(bench.configure({.device = "tapped", .route = "[[0.4, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  tap.garble_every(97);  // about every second reply, each time another byte of it
  CHECK(daemon->wait(20s) == 0);
  robot->end();
  CHECK(replies_of(daemon->out()).garbled > 20);
  check_no_sample_is_shifted(bench.drive_log(), 1.2, 2.2);
  check_counts_are_the_travel(bench.drive_log(), bench.truth());
}

TEST_CASE("Text that the robot prints by itself is told, and shifts nothing") {
  Bench bench;
  const auto robot = bench.start_robot(
      "perfect", "link: { stray_text: \"battery-voltage 14.6V\\r\\n\", stray_text_interval_s: 0.7 }\n");
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[0.4, 0]]"}));
  CHECK(daemon->wait(20s) == 0);
  robot->end();
  CHECK_THAT(daemon->err(), ContainsSubstring("the robot prints: "));
  check_no_sample_is_shifted(bench.drive_log(), 1.2, 2.2);
  check_counts_are_the_travel(bench.drive_log(), bench.truth());
}

TEST_CASE("Replies that come one to three ticks late are counted, and none is taken for a later one") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon = bench.start_daemon(bench.configure(
      {.device = "tapped", .link = "blind_limit_s: 1, lost_after_s: 2", .route = "[[0.4, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(800ms);
  for (const auto delay : {25ms, 0ms, 42ms, 0ms, 60ms, 0ms}) {
    tap.delay_replies(delay);
    std::this_thread::sleep_for(150ms);
  }
  CHECK(daemon->wait(20s) == 0);
  robot->end();
  const Replies replies = replies_of(daemon->out());
  CHECK(replies.asked - replies.sound >= 15);
  CHECK(rows_without_sample(bench.drive_log()) >= 15);
  check_no_sample_is_shifted(bench.drive_log(), 1.2, 2.2);
  check_counts_are_the_travel(bench.drive_log(), bench.truth());
}

TEST_CASE("A silence below the blind limit is survived, a longer one stops the run") {
  const bool longer = GENERATE(false, true);
  CAPTURE(longer);
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const auto daemon = bench.start_daemon(bench.configure({.device = "tapped", .route = "[[0.4, 0]]"}));
  REQUIRE(daemon->says("route: driving", 10s));
  std::this_thread::sleep_for(500ms);
  tap.lose_replies(true);
  std::this_thread::sleep_for(longer ? 500ms : 120ms);
  tap.lose_replies(false);
  CHECK(daemon->wait(20s) == (longer ? 1 : 0));
  CHECK(replies_of(daemon->out()).missing >= 5);
  if (longer) CHECK_THAT(daemon->out(), ContainsSubstring("no valid sensor reading for too long"));
}
