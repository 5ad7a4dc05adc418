// The daemon on a recording of a real Create 2: what the robot counted is what the daemon logs.
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include "config/load/drive_log_file.hpp"
#include "tests/loopback/bench/bench.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::bench;

namespace {

constexpr double played_until_s = 10.0;  // of 33, to save time

std::optional<std::filesystem::path> recording() {
  const char* given = std::getenv("WHEELWRIGHT_DATA");
  const auto data = given != nullptr
                        ? std::filesystem::path(given)
                        : std::filesystem::path(WHEELWRIGHT_SOURCE_DIR).parent_path() / "shared" / "data";
  const auto file = data / "create2" / "run1.csv";
  return std::filesystem::exists(file) ? std::optional(file) : std::nullopt;
}

}  // namespace

TEST_CASE("A recorded drive of a real robot comes back from the daemon count by count") {
  const auto recorded = recording();
  if (!recorded) {
    return skip("no Create 2 logs; set WHEELWRIGHT_DATA to the folder that holds create2/run1.csv");
  }
  auto log = wheelwright::config::load_drive_log(*recorded);
  while (log.samples.back().t_s > played_until_s) log.samples.pop_back();
  log.extra_columns.clear();
  Bench bench;
  const auto played = bench.folder() / "recorded.csv";
  wheelwright::config::save_drive_log(log, played);
  const auto robot = bench.start_robot("default", "", {"--replay", played.string()});
  // A route that takes longer than the recording, which begins with the first order to move.
  const auto daemon = bench.start_daemon(bench.configure({.route = "[[2.4, 0]]"}));
  CHECK(daemon->wait(40s) == 0);

  const Table written = bench.drive_log();
  CHECK(bench.pose_log().rows() == written.rows());
  const auto origin = *log.samples.front().ticks;
  const auto end = *log.samples.back().ticks;
  REQUIRE(end.left - origin.left > 1000);
  const std::size_t last = written.rows() - 1;
  CHECK(written.number(last, "ticks_left") == static_cast<double>(end.left - origin.left));
  CHECK(written.number(last, "ticks_right") == static_cast<double>(end.right - origin.right));

  std::set<std::pair<double, double>> counted;
  for (const auto& sample : log.samples) {
    counted.emplace(static_cast<double>(sample.ticks->left - origin.left),
                    static_cast<double>(sample.ticks->right - origin.right));
  }
  for (std::size_t row = 0; row < written.rows(); ++row) {
    if (written.empty(row, "ticks_left")) continue;
    CAPTURE(row);
    CHECK(counted.contains({written.number(row, "ticks_left"), written.number(row, "ticks_right")}));
  }
}

TEST_CASE(
    "A robot that plays the log of a run answers the same drive with the same counts, from its start on") {
  Bench bench;
  auto robot = bench.start_robot("default");
  const auto config = bench.configure({});
  REQUIRE(bench.start_daemon(config)->wait(30s) == 0);
  robot->end();
  const Table first = bench.drive_log();

  // Another robot by nature: what it counts by itself is something else.
  robot = bench.start_robot("create2", "", {"--replay", (bench.runs().back() / "drive_log.csv").string()});
  REQUIRE(bench.start_daemon(config)->wait(30s) == 0);
  const Table again = bench.drive_log();
  for (const char* wheel : {"ticks_left", "ticks_right"}) {
    const double end = first.number(first.rows() - 1, wheel);
    CHECK(end > 400.0);
    CHECK(again.number(again.rows() - 1, wheel) == end);
  }
  CHECK(std::abs(static_cast<double>(first.rows()) - static_cast<double>(again.rows())) < 20);
}
