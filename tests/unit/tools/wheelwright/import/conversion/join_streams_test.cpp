#include "tools/wheelwright/import/conversion/join_streams.hpp"

#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

using namespace wheelwright::import;

namespace {

std::vector<double> every(double step_s, int count, double start_s = 0.0) {
  std::vector<double> t_s;
  for (int k = 0; k < count; ++k) t_s.push_back(start_s + step_s * k);
  return t_s;
}

}  // namespace

TEST_CASE("A command holds until the next, from the row that is nearest to it") {
  const std::vector<double> sent_s{0.02, 0.26, 0.44};
  const std::vector<double> commands{1.0, 2.0, 3.0};
  const auto joined = join(sent_s, commands, every(0.1, 7), Joining::held);
  CHECK(joined == std::vector<double>{1.0, 1.0, 1.0, 2.0, 3.0, 3.0, 3.0});
}

TEST_CASE("Before the first command there is none") {
  const auto joined = join(std::vector<double>{0.3}, std::vector<double>{1.0}, every(0.1, 5), Joining::held);
  CHECK(std::isnan(joined[2]));
  CHECK(joined[3] == 1.0);
}

TEST_CASE("Places lie on the line between two neighbours, and none across a hole") {
  auto seen_s = every(0.02, 50);
  for (const double t : every(0.02, 50, 3.0)) seen_s.push_back(t);
  std::vector<double> places;
  for (const double t : seen_s) places.push_back(2.0 * t);
  const auto rows_s = every(0.05, 80);
  const auto joined = join(seen_s, places, rows_s, Joining::between);
  for (std::size_t row = 0; row < rows_s.size(); ++row) {
    INFO("at " << rows_s[row] << " s");
    const bool in_hole = rows_s[row] > 0.98 + 1e-9 && rows_s[row] < 3.0 - 1e-9;
    if (in_hole) {
      CHECK(std::isnan(joined[row]));
    } else if (rows_s[row] < 3.97) {
      CHECK_THAT(joined[row], WithinAbs(2.0 * rows_s[row], 1e-9));
    }
  }
}

TEST_CASE("A pose at each end of a run goes to the nearest row") {
  const auto joined = join(std::vector<double>{0.01, 59.98}, std::vector<double>{5.0, 7.0}, every(0.05, 1201),
                           Joining::between);
  CHECK(joined.front() == 5.0);
  CHECK(joined.back() == 7.0);
  CHECK(std::isnan(joined[600]));
}

TEST_CASE("A row without a time, in the middle or at the end, takes nothing from the others") {
  const std::vector<double> sent_s{0.0, 0.3, 0.6};
  const std::vector<double> commands{1.0, 2.0, 3.0};
  const auto whole = join(sent_s, commands, every(0.1, 10), Joining::held);
  for (const std::size_t row : {std::size_t{4}, std::size_t{9}}) {
    auto rows_s = every(0.1, 10);
    rows_s[row] = nothing;
    const auto joined = join(sent_s, commands, rows_s, Joining::held);
    for (std::size_t i = 0; i < joined.size(); ++i)
      if (i != row) CHECK(joined[i] == whole[i]);
  }
}

TEST_CASE("Where both clocks start again each part is joined to its own") {
  auto rows_s = every(0.1, 400);
  auto sent_s = every(2.0, 20);
  std::vector<double> commands;
  for (const double t : sent_s) commands.push_back(t);
  for (const double t : every(0.1, 300)) rows_s.push_back(t);
  for (const double t : every(2.0, 15)) {
    sent_s.push_back(t);
    commands.push_back(100.0 + t);
  }
  const auto joined = join(sent_s, commands, rows_s, Joining::held);
  CHECK(joined[25] == 2.0);
  CHECK(joined[399] == 38.0);
  CHECK(joined[400] == 100.0);
  CHECK(joined[699] == 128.0);
}

TEST_CASE("Rows of clocks that start again are united part by part") {
  auto first = every(1.0, 10);
  auto second = every(1.0, 10, 0.5);
  for (const double t : every(1.0, 3)) first.push_back(t);
  for (const double t : every(1.0, 2, 0.5)) second.push_back(t);
  const UnitedRows united = unite_rows(std::vector{first, second});
  REQUIRE(united.t_s.size() == 25);
  CHECK(united.t_s[19] == 9.5);
  CHECK(united.t_s[20] == 0.0);
  CHECK(united.rows[1].back() == 23);
}
