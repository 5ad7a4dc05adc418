// What a soak counts, and what it must come to.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drivers/simulation/cable_fault.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright::soak {

// What became of the faults of one kind; every fault is in exactly one row of these.
struct KindFigures {
  std::int64_t injected = 0;
  std::int64_t idle = 0;       // nothing travelled that it could have hit
  std::int64_t unnoticed = 0;  // it hit bytes, and no sample was lost by it
  std::int64_t cost_samples = 0;
  std::int64_t stopped_run = 0;
};

// A return of the link to a robot that is there: from the end of the fault to the first sound reading.
struct Recovery {
  std::int64_t count = 0;
  std::int64_t within_1_s = 0;
  double longest_s = 0.0;
};

struct SoakFigures {
  std::array<KindFigures, simulation::cable_fault_kinds> kinds;
  double duration_s = 0.0;
  double driven_m = 0.0;

  std::int64_t asked = 0;
  std::int64_t sound = 0;
  std::int64_t missing = 0;
  std::int64_t incomplete = 0;
  std::int64_t garbled = 0;
  // Bad replies when no fault was at work: because damaged bytes had sent the robot away (to boot, to sleep),
  // because it waited for the rest of a damaged command, or for no such reason.
  std::int64_t lost_while_away = 0;
  std::int64_t lost_in_half_commands = 0;
  std::int64_t lost_outside = 0;
  std::int64_t wrong_in_faults = 0;  // samples that were taken although their counts are wrong, where hit
  std::int64_t wrong_outside = 0;    // and where nothing was hit

  std::map<StopReason, std::int64_t> stops;
  std::int64_t moving_orders_disarmed = 0;  // must be none
  std::int64_t blind_segments = 0;          // longer than the limit while armed
  std::int64_t not_at_rest_when_blind = 0;  // of these, though the robot could hear: must be none
  double longest_to_rest_s = 0.0;           // from the limit on
  std::int64_t runaways = 0;                // the robot could not hear and rolled on
  double longest_rest_after_return_s = 0.0;

  Recovery recovery;
  Recovery recovery_of_reset_robot;      // damaged bytes had it boot: from when it listens again
  std::int64_t switched_off_and_on = 0;  // damaged bytes had it sleep or talk at another speed
  std::int64_t failed_recoveries = 0;    // none of the above within 10 s: must be none

  std::int64_t injected() const;
};

// One line for each thing that is not as it must be.
std::vector<std::string> shortcomings(const SoakFigures& figures);

std::string to_text(const SoakFigures& figures);

}  // namespace wheelwright::soak
