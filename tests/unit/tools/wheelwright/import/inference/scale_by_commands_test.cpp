// How far a count goes, where commands alone tell it.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

// A minute of wheels that come to their speed with a lag of 0.3 s, at any rate of rows.
std::string slow_wheels(double period_s) {
  constexpr double lag_s = 0.3;
  constexpr double metres_per_count = 0.0001;
  constexpr double fine_s = 0.001;
  constexpr double commands[] = {0.0, 0.2, 0.1, -0.15, 0.25, 0.05, 0.18, -0.1, 0.22, 0.12};
  std::string text = "t,cmd_left,cmd_right,ticks_left,ticks_right\n";
  double left_m = 0.0, right_m = 0.0, left_m_s = 0.0, right_m_s = 0.0, next_row_s = 0.0;
  for (double t_s = 0.0; t_s < 60.0; t_s += fine_s) {
    const auto k = static_cast<std::size_t>(t_s / 1.7);
    const double left = commands[k % 10];
    const double right = commands[(k + k / 10 + 3) % 10];
    if (t_s >= next_row_s - 1e-9) {
      next_row_s += period_s;
      text += number(t_s) + "," + number(left) + "," + number(right) + "," +
              std::to_string(std::lround(left_m / metres_per_count)) + "," +
              std::to_string(std::lround(right_m / metres_per_count)) + "\n";
    }
    left_m_s += fine_s / lag_s * (left - left_m_s);
    right_m_s += fine_s / lag_s * (right - right_m_s);
    left_m += fine_s * left_m_s;
    right_m += fine_s * right_m_s;
  }
  return text;
}

}  // namespace

// A response is fitted over 1.5 s: 0.7 % of what a lag of 0.3 s answers lies beyond, and edges of commands
// that fall within a row add to that.
TEST_CASE("Wheels that come to their speed slowly have the same scale at any rate of rows") {
  constexpr double beyond_the_response = 0.015;
  for (const double period_s : {0.005, 0.01, 0.02, 0.05}) {
    CAPTURE(period_s);
    const ImportOutcome outcome = import_text(slow_wheels(period_s), {"robot.wheel_base_m=0.3"});
    if (!outcome.conversion) FAIL(outcome.conversion.error());
    CHECK_THAT(outcome.conversion->runs.front().metres_per_tick->left,
               WithinRel(0.0001, beyond_the_response));
  }
}
