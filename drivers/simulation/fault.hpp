// What can be done to a simulated robot from outside while it runs.
#pragma once

#include "drivers/simulation/room.hpp"

namespace wheelwright::simulation {

enum class Side { left, right };

struct Fault {
  enum class Kind {
    lift_wheel,  // off the floor: no traction, and its wheel-drop switch opens
    set_down_wheel,
    stall_wheel,     // jammed: it does not turn whatever the motor does
    free_wheel,      // no longer jammed
    freeze_encoder,  // counts stand still while the wheel turns
    thaw_encoder,
    add_counts,    // a spike (`counts` > 0 or < 0) in the counter, or counts lost
    change_floor,  // `surface` everywhere
    plug_charger,
    unplug_charger,
    power_off,    // battery out: motors off, silence
    power_on,     // boot text, then Off mode
    press_clean,  // wakes a sleeping robot
  };
  Kind kind;
  Side side = Side::left;
  int counts = 0;
  Surface surface = {};
};

}  // namespace wheelwright::simulation
