// An error of measured headings or positions that depends on the heading, as of a compass beside iron.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

struct OffsetOverHeading {
  double p_value = 1.0;
  double size = 0.0;                             // amplitude of the larger harmonic, m or rad
  int harmonic = 1;                              // swings per turn of that one
  std::vector<std::pair<double, double>> curve;  // heading, offset
};

// Sine and cosine of the heading and of twice the heading are added to the measured series of a channel and
// whitened as its errors are; with X the whitened columns and z the innovations, z' X (X' X)^-1 X' z is
// chi-squared with four degrees of freedom where there is no such offset (a score test). It is divided by the
// variance ratio of sums over 2 s of what is left. `heading` holds the predicted heading at each reading;
// none where it hardly turns.
std::optional<OffsetOverHeading> offset_over_heading(const FitProblem& problem,
                                                     std::span<const ResidualTrack* const> tracks,
                                                     std::span<const std::vector<double>> heading);

}  // namespace wheelwright::gap
