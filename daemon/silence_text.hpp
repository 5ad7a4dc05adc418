// Why no sound reading came for too long, and what to do: whether the machine, the cable or the robot is the
// cause.
#pragma once

#include <string>

#include "drivers/roomba/silence.hpp"
#include "model/geometry/sensor_period.hpp"

namespace wheelwright::daemon {

// How busy the machine was.
struct MachineLoad {
  double processes = 0.0;  // that ran or waited to, mean of the last minute
  int cores = 1;

  bool is_busy() const { return processes > cores; }
};
MachineLoad machine_load();

struct SilenceContext {
  double period_s = default_period_s;
  MachineLoad load;
};

// One line, to follow the reason of the stop.
std::string explain(const roomba::Silence& silence, const SilenceContext& context);

}  // namespace wheelwright::daemon
