// Speeds at which the wheels settle while a command is held: what runs show of the curve from command to
// speed.
//
// A linear model has one gain for all commands; robots need not. Where a wheel's own command stays for some
// time, its counts tell the speed at which it settled, whatever the model says. What it still owes to the
// commands before (the wheel lags behind) is taken from the model's free run, so that short holds count too.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/identification/fir_fit.hpp"
#include "model/log/drive_log.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

struct SteadyStateSpeed {
  double command_m_s = 0.0;
  double speed_m_s = 0.0;
  double standard_error_m_s = 0.0;  // by noise of the counts, drift, and scatter between holds
  std::size_t holds = 0;
  double held_s = 0.0;  // all holds together, without the time in which the wheel settled
};

struct SteadyStateSpeeds {
  std::vector<SteadyStateSpeed> left;  // by rising command; rest is no speed
  std::vector<SteadyStateSpeed> right;
};

// `model` is a moving average fitted to the runs, `left` and `right` what its fit says of the wheels' noise.
SteadyStateSpeeds steady_state_speeds(std::span<const DriveLog> logs, const LinearModel& model,
                                      const WheelFit& left, const WheelFit& right);

}  // namespace wheelwright
