#include "drivers/roomba/stop_reason.hpp"

namespace wheelwright::roomba {

StopReason stop_reason_in(const open_interface::Reading& reading, double lowest_battery_v) {
  constexpr unsigned bumps = 3U;
  constexpr unsigned wheel_drops = 12U;
  constexpr unsigned wheel_overcurrents = 24U;
  constexpr int charging_fault = 5;
  if ((reading.bumps_and_wheel_drops & wheel_drops) != 0) return StopReason::wheel_drop;
  if (reading.cliff) return StopReason::cliff;
  if ((reading.bumps_and_wheel_drops & bumps) != 0) return StopReason::bump;
  if ((reading.overcurrents & wheel_overcurrents) != 0) return StopReason::overcurrent;
  if (reading.charging_state != 0 && reading.charging_state < charging_fault) return StopReason::charging;
  if (reading.voltage_mv < static_cast<int>(1000.0 * lowest_battery_v)) return StopReason::low_battery;
  return StopReason::none;
}

}  // namespace wheelwright::roomba
