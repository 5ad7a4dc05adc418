// What in a reading must stop the wheels.
#pragma once

#include "drivers/open_interface/reading.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright::roomba {

// The worst of what is wrong, or none.
StopReason stop_reason_in(const open_interface::Reading& reading, double lowest_battery_v);

}  // namespace wheelwright::roomba
