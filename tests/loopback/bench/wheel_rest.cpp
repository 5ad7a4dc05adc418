#include "tests/loopback/bench/wheel_rest.hpp"

#include <chrono>
#include <cmath>

namespace wheelwright::bench {
namespace {

constexpr double at_rest_m_s = 0.001;

bool moves(const Table& truth, std::size_t row) {
  return std::abs(truth.number(row, "speed_left")) > at_rest_m_s ||
         std::abs(truth.number(row, "speed_right")) > at_rest_m_s;
}

double unix_ms(const Table& truth, std::size_t row) {
  return std::stod(truth.metadata("started_unix_ms")) + 1e3 * truth.number(row, "t");
}

}  // namespace

double unix_ms_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

double ms_to_rest(const Table& truth, double from_unix_ms, double until_unix_ms) {
  double last_moving_ms = from_unix_ms;
  for (std::size_t row = 0; row < truth.rows() && unix_ms(truth, row) < until_unix_ms; ++row) {
    if (moves(truth, row)) last_moving_ms = unix_ms(truth, row);
  }
  return last_moving_ms - from_unix_ms;
}

double speed_at(const Table& truth, double at_unix_ms) {
  std::size_t row = 0;
  while (row + 1 < truth.rows() && unix_ms(truth, row) < at_unix_ms) ++row;
  return 0.5 * (truth.number(row, "speed_left") + truth.number(row, "speed_right"));
}

}  // namespace wheelwright::bench
