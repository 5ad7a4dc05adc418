#include "model/gap/noise/steadiness.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;

std::vector<double> unsteady(std::initializer_list<std::pair<WheelPair, int>> stretches) {
  std::vector<WheelPair> commands_m_s;
  for (const auto& [command_m_s, periods] : stretches)
    commands_m_s.insert(commands_m_s.end(), static_cast<std::size_t>(periods), command_m_s);
  return unsteady_periods(commands_m_s, period_s);
}

auto of(const std::vector<double>& all, int first, int last) {
  return std::vector<double>(all.begin() + first, all.begin() + last);
}

const auto all_are = [](const std::vector<double>& values, double value) {
  return std::ranges::all_of(values, [value](double one) { return one == value; });
};

}  // namespace

TEST_CASE("Commands are unsteady for a second after each change, and after a start") {
  const auto driven = unsteady({{{0.2, 0.2}, 100}, {{0.2, 0.1}, 100}});
  CHECK(all_are(of(driven, 0, 50), 1.0));
  CHECK(all_are(of(driven, 50, 100), 0.0));
  CHECK(all_are(of(driven, 100, 150), 1.0));
  CHECK(all_are(of(driven, 150, 200), 0.0));
  CHECK(all_are(unsteady({{{0.0, 0.0}, 100}}), 0.0));
}

TEST_CASE("What a follower corrects on a straight way is steady") {
  CHECK(all_are(of(unsteady({{{0.2, 0.2}, 100}, {{0.195, 0.205}, 100}}), 60, 200), 0.0));
  CHECK(all_are(of(unsteady({{{0.2, 0.2}, 100}, {{0.17, 0.23}, 100}}), 100, 150), 1.0));
}

TEST_CASE("The share of unsteady time before a reading is that since the reading before") {
  const std::vector<double> periods{1.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  const std::vector<double> times_s{0.0, 0.02, 0.06, 0.10, 0.12};
  const auto shares = unsteady_shares(periods, times_s, period_s);
  CHECK_THAT(shares[1], WithinAbs(1.0, 1e-12));
  CHECK_THAT(shares[2], WithinAbs(0.5, 1e-12));
  CHECK_THAT(shares[3], WithinAbs(0.0, 1e-12));
  CHECK_THAT(shares[4], WithinAbs(1.0, 1e-12));
}
