#include "tools/wheelwright/export/first_order_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelwright::tools {
namespace {

constexpr std::size_t response_periods = 2000;
constexpr std::size_t compared_periods = 400;

// Of a wheel to its own command, one value a period.
std::vector<double> own_response(const LinearModel& linear_part, bool left) {
  const TwistResponse response = twist_response(linear_part, response_periods);
  const auto& v = left ? response.v_from_left : response.v_from_right;
  const auto& w = left ? response.w_from_left : response.w_from_right;
  std::vector<double> own(response_periods);
  for (std::size_t k = 0; k < own.size(); ++k) {
    const WheelPair speed = wheels_of_twist({v[k], w[k]}, linear_part.wheel_base_m);
    own[k] = left ? speed.left : speed.right;
  }
  return own;
}

// The way by time `t_s` after a step to 1 m/s.
double step_way_m(double t_s, double dead_time_s, double lag_s) {
  const double since_s = t_s - dead_time_s;
  return since_s <= 0.0 ? 0.0 : since_s - lag_s * (1.0 - std::exp(-since_s / lag_s));
}

// Speeds of the model are means over a period, and so are these.
double squared_error(const std::vector<double>& step, double period_s, double dead_time_s, double lag_s) {
  double sum = 0.0;
  double before_m = 0.0;
  for (std::size_t k = 0; k < compared_periods; ++k) {
    const double way_m = step_way_m(period_s * static_cast<double>(k + 1), dead_time_s, lag_s);
    sum += std::pow(step[k] - (way_m - before_m) / period_s, 2);
    before_m = way_m;
  }
  return sum;
}

double best_dead_time_s(const std::vector<double>& step, double period_s, double mean_delay_s) {
  constexpr int divisions = 400;
  constexpr int most = divisions * 95 / 100;  // a simulator's motor needs some lag
  double best_s = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= most; ++i) {
    const double dead_time_s = mean_delay_s * i / divisions;
    const double error = squared_error(step, period_s, dead_time_s, mean_delay_s - dead_time_s);
    if (error >= least) continue;
    least = error;
    best_s = dead_time_s;
  }
  return best_s;
}

}  // namespace

FirstOrderResponse first_order_response(const LinearModel& linear_part, bool left) {
  const std::vector<double> response = own_response(linear_part, left);
  double sum = 0.0;
  double moment = 0.0;
  for (std::size_t k = 0; k < response.size(); ++k) {
    sum += response[k];
    moment += response[k] * static_cast<double>(k);
  }
  const double mean_delay_s = sum == 0.0 ? 0.0 : linear_part.period_s * moment / sum;
  if (!(mean_delay_s > 0.0)) return {mean_delay_s, 0.0, 0.0};
  std::vector<double> step(response.size());
  double reached = 0.0;
  for (std::size_t k = 0; k < response.size(); ++k) step[k] = (reached += response[k]) / sum;
  const double dead_time_s = best_dead_time_s(step, linear_part.period_s, mean_delay_s);
  return {mean_delay_s, dead_time_s, mean_delay_s - dead_time_s};
}

}  // namespace wheelwright::tools
