#include "tools/wheelwright/import/conversion/join_streams.hpp"

#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"

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
