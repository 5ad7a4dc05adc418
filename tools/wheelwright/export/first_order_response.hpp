// The linear part of a wheel as what simulators know: a dead time and a first-order lag.
#pragma once

#include "model/simulation/linear_model.hpp"

namespace wheelwright::tools {

struct FirstOrderResponse {
  double mean_delay_s = 0.0;  // of the step response; the sum of the two below
  double dead_time_s = 0.0;
  double lag_s = 0.0;  // time constant
};

// Keeps the mean delay, which places the robot; how it divides is least squares over the step response. All
// zero where the wheel does not answer, or answers before its command.
FirstOrderResponse first_order_response(const LinearModel& linear_part, bool left);

}  // namespace wheelwright::tools
