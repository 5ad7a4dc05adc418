#include "tools/wheelwright/import/conversion/time_repair.hpp"

#include <limits>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright::import;

namespace {

std::vector<double> clock(int rows, double start_s = 0.0) {
  std::vector<double> t_s;
  for (int k = 0; k < rows; ++k) t_s.push_back(start_s + 0.05 * k);
  return t_s;
}

TimeRepair repair(const std::vector<double>& t_s, bool alike = true, bool at_rest = true) {
  return repair_time(
      t_s, {[](std::size_t row) { return "line " + std::to_string(row + 1); },
            [alike](std::size_t, std::size_t) { return alike; }, [at_rest](std::size_t) { return at_rest; }});
}

std::vector<double> times(const std::vector<double>& t_s, const RunRows& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(t_s[row]);
  return result;
}

}  // namespace

TEST_CASE("A clock that rises evenly is one run, and nothing is said") {
  const auto repaired = repair(clock(100));
  REQUIRE(repaired.runs.size() == 1);
  CHECK(repaired.runs.front().size() == 100);
  CHECK(repaired.remarks.empty());
}

TEST_CASE("Where the clock is set back a new run begins, and the row is named") {
  for (const double by_s : {3.0, 0.4, 3600.0, 5e8}) {
    INFO("by " << by_s << " s");
    auto t_s = clock(100, 1e9);
    for (const double t : clock(100, 1e9 + 5.0 - by_s)) t_s.push_back(t);
    const auto repaired = repair(t_s);
    REQUIRE(repaired.runs.size() == 2);
    CHECK(repaired.runs.back().size() == 100);
    REQUIRE(repaired.remarks.size() == 1);
    CHECK_THAT(repaired.remarks.front(), ContainsSubstring("line 101: the clock goes back by"));
  }
}

TEST_CASE("Where the clock jumps ahead by hours or decades a new run begins") {
  for (const double by_s : {3600.0, 1.7e9}) {
    auto t_s = clock(100);
    for (const double t : clock(100, 5.0 + by_s)) t_s.push_back(t);
    const auto repaired = repair(t_s);
    REQUIRE(repaired.runs.size() == 2);
    CHECK_THAT(repaired.remarks.front(), ContainsSubstring("line 101: no rows for"));
  }
}

TEST_CASE("A robot that drives goes on behind a hole of ten seconds, whatever the clock says") {
  for (const double by_s : {-3.0, 3600.0, 1.7e9}) {
    INFO("by " << by_s << " s");
    auto t_s = clock(100, 100.0);
    for (const double t : clock(100, 105.0 + by_s)) t_s.push_back(t);
    const auto repaired = repair(t_s, true, false);
    REQUIRE(repaired.runs.size() == 1);
    CHECK(repaired.runs.front().size() == 200);
    CHECK_THAT(repaired.t_s[100] - repaired.t_s[99], WithinAbs(10.0, 1e-6));
    CHECK_THAT(repaired.t_s[199] - repaired.t_s[100], WithinAbs(99 * 0.05, 1e-6));
    CHECK_THAT(repaired.remarks.front(), ContainsSubstring("line 101: "));
  }
}

TEST_CASE("A clock that starts again from zero is a new run, also of a robot that drives") {
  auto t_s = clock(100);
  for (const double t : clock(100)) t_s.push_back(t);
  CHECK(repair(t_s, true, false).runs.size() == 2);
}

TEST_CASE("A hole of some seconds stays in its run") {
  auto t_s = clock(100);
  for (const double t : clock(100, 9.0)) t_s.push_back(t);
  CHECK(repair(t_s).runs.size() == 1);
}

TEST_CASE("Rows out of order are sorted and named, and make no run of their own") {
  auto t_s = clock(100);
  std::swap(t_s[40], t_s[41]);
  const double late = t_s[60];
  t_s.erase(t_s.begin() + 60);
  t_s.insert(t_s.begin() + 63, late);
  const auto repaired = repair(t_s);
  REQUIRE(repaired.runs.size() == 1);
  CHECK(times(t_s, repaired.runs.front()) == clock(100));
  CHECK_THAT(repaired.remarks.front(), ContainsSubstring("line 42, line 64: out of order, sorted by time"));
}

TEST_CASE("Of two rows with one stamp the later stays, and whether they differ is said") {
  auto t_s = clock(50);
  t_s.insert(t_s.begin() + 20, t_s[20]);
  const auto alike = repair(t_s, true);
  REQUIRE(alike.runs.size() == 1);
  CHECK(times(t_s, alike.runs.front()) == clock(50));
  CHECK_THAT(alike.remarks.front(),
             ContainsSubstring("line 22: the stamp of the row before once more, with the same values"));
  CHECK_THAT(repair(t_s, false).remarks.front(), ContainsSubstring("the later row is kept"));
}

TEST_CASE("Rows without a time are left out and named") {
  auto t_s = clock(50);
  t_s[7] = std::numeric_limits<double>::quiet_NaN();
  const auto repaired = repair(t_s);
  REQUIRE(repaired.runs.size() == 1);
  CHECK(repaired.runs.front().size() == 49);
  CHECK_THAT(repaired.remarks.front(), ContainsSubstring("line 8: no time, left out"));
}
