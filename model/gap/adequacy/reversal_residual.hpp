// A residual that is larger after a wheel's command changes sign than elsewhere, to whichever side: play,
// stiction, a caster, where the library's effects do not explain it.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

struct ReversalResidual {
  double p_value = 1.0;
  double ratio = 1.0;  // median power of the windows after a reversal over that elsewhere
  double size = 0.0;   // root mean square of what reversals add to a free run in 10 s, m: of the change of
                       // its error in a window, the share of the power that is beyond that elsewhere
  double share = 0.0;  // of the power
  double share_of_time = 0.0;                    // of the windows after a reversal
  std::vector<std::pair<double, double>> power;  // time since a reversal, s, and mean squared innovation
};

// Power is the mean squared innovation of a window of 0.7 s: after each change of the command's sign, and
// from one window to the next elsewhere while the command is not zero. Wilcoxon's rank sum test (1945)
// compares the two; it asks nothing of the noise but that it is the same in both. None where there are fewer
// than ten windows of either kind.
std::optional<ReversalResidual> reversal_residual(const FitProblem& problem,
                                                  std::span<const ResidualTrack* const> tracks);

}  // namespace wheelwright::gap
