// A residual that depends on something: on the command, the heading, the place, the time.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

// The value of one quantity at each reading of each track; not-a-number where it is not known.
struct Covariate {
  std::string_view name;  // as in "heading"
  std::string_view unit;
  std::vector<std::vector<double>> value;
  // 1 or -1 at each reading, where the sign of what is looked for follows another quantity; empty: 1
  // everywhere.
  std::vector<std::vector<double>> sign = {};

  double sign_at(std::size_t track, std::size_t reading) const {
    return sign.empty() ? 1.0 : sign[track][reading];
  }
};

struct Dependence {
  double p_value = 1.0;
  double size = 0.0;  // root mean square of what it comes to in a free run of 10 s, m or rad
  double from = 0.0;  // the range of the covariate where the residual lies furthest from its mean
  double to = 0.0;
  double share_of_time = 0.0;  // of that range
  std::vector<std::pair<double, double>>
      rates;           // middle of each bin, mean rate of the error there, m/s or rad/s
  double share = 0.0;  // of the mean square of the free-run error after 10 s
};

// Innovations are sorted into up to eight bins of equal count over the covariate; bins that it came to fewer
// than three times are left out. Where the model is adequate, the sum over bins of count times squared mean,
// about the overall mean, is chi-squared with one degree less than there are bins. It is divided by the
// largest variance ratio of sums over visits of a bin and over 2, 4 and 8 s, so that noise which is not quite
// as modelled shows no dependence. None where there are fewer than three bins.
std::optional<Dependence> dependence(std::span<const ResidualTrack* const> tracks,
                                     const Covariate& covariate);

}  // namespace wheelwright::gap
