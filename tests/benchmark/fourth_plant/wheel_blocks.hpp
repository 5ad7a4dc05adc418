// Blocks on the speed of one wheel, in the gear, before the counter or on the floor.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/fourth_plant/block.hpp"

namespace plants::fourth {

// Play: the driven side follows only when the gap is taken up. Taken up forward at the start.
struct Play {
  double gap_m;
  double taken_up_m = 0.0;  // 0 = forward flank touches, -gap = the other
  double operator()(double input, const Moment& moment) {
    const double wanted_m = taken_up_m + input * moment.step_s;
    taken_up_m = std::clamp(wanted_m, -gap_m, 0.0);
    return (wanted_m - taken_up_m) / moment.step_s;
  }
};

// Distance for each turn of the shaft swells and shrinks once per turn.
struct OncePerTurn {
  double ripple;
  double metres_per_turn;
  double turned_rad;
  bool anywhere = false;  // nobody homed the wheel before the run
  double operator()(double input, const Moment& moment) {
    if (anywhere) turned_rad = moment.random->uniform(0.0, 2.0 * std::numbers::pi);
    anywhere = false;
    turned_rad += 2.0 * std::numbers::pi / metres_per_turn * input * moment.step_s;
    return input * (1.0 + ripple * std::cos(turned_rad));
  }
};

struct Scale {
  double scale;
  double operator()(double input, const Moment& /*moment*/) const { return scale * input; }
};

// A tyre with a relaxation length that gives way above what the floor holds, and then drives less than it
// turns.
struct SlippingTyre {
  double grip_m_s2;
  double slip_s;  // speed lost for each m/s2 above the grip
  double relaxation_m;
  double last_m_s = 0.0;
  double acceleration_m_s2 = 0.0;
  double slip_m_s = 0.0;
  double operator()(double input, const Moment& moment) {
    constexpr double contact_s = 0.015;
    const double share = moment.step_s / contact_s;
    acceleration_m_s2 += share * ((input - last_m_s) / moment.step_s - acceleration_m_s2);
    last_m_s = input;
    const double target_m_s = slip_s * std::max(0.0, std::abs(acceleration_m_s2) - grip_m_s2);
    constexpr double creep_m_s = 0.1;  // the tyre also relaxes while it hardly rolls
    slip_m_s += moment.step_s * (std::abs(input) + creep_m_s) / relaxation_m * (target_m_s - slip_m_s);
    return std::copysign(std::max(0.0, std::abs(input) - slip_m_s), input);
  }
};

// Now and then a register stands still, or light falls past the disc. What was turned meanwhile is counted
// afterwards (`catches_up`) or never.
struct Dropout {
  double per_s;
  double shortest_s;
  double longest_s;
  bool catches_up;
  double until_s = -1.0;
  double missed_m = 0.0;
  double operator()(double input, const Moment& moment) {
    if (moment.time_s > until_s && moment.random->chance(per_s * moment.step_s))
      until_s = moment.time_s + moment.random->uniform(shortest_s, longest_s);
    if (moment.time_s <= until_s) {
      missed_m += input * moment.step_s;
      return 0.0;
    }
    const double late_m = catches_up ? missed_m : 0.0;
    missed_m = 0.0;
    return input + late_m / moment.step_s;
  }
};

}  // namespace plants::fourth
