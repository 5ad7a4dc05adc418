// What settled speeds show beyond one gain: a curve that bends, and speeds that go in steps.
//
// Both are told only where they stand out of the scatter of the speeds themselves. The size of a command
// counts, not its direction.
#pragma once

#include <cstddef>
#include <optional>

#include "model/identification/steady_state_speeds.hpp"

namespace wheelwright {

struct GainAt {
  double command_m_s = 0.0;
  double gain = 0.0;  // m/s reached per m/s commanded
  double standard_error = 0.0;
};

// The gain is not the same for small and large commands. Low above high: the curve is concave.
struct GainBend {
  GainAt low;
  GainAt high;
};

// Commands within one step settle at one speed.
struct SpeedSteps {
  double step_m_s = 0.0;      // of command
  double smallest_m_s = 0.0;  // 95 % interval; steps that these commands cannot tell apart lie in it as well
  double largest_m_s = 0.0;
  double p_value = 0.0;  // that a smooth curve scatters like this, the search for the step counted in
};

struct SpeedCurve {
  std::size_t commands = 0;  // sizes that were held
  std::optional<GainBend> bend;
  std::optional<SpeedSteps> steps;
};

SpeedCurve find_speed_curve(const SteadyStateSpeeds& speeds);

}  // namespace wheelwright
