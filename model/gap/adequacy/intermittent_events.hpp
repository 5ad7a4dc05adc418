// A residual that comes at a few moments: a contact that fails, a link that loses commands, a wheel that
// slips or is held for a moment. To the noise model it is noise, but noise is there all the time.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/gap/adequacy/covariates.hpp"
#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

struct IntermittentEvents {
  struct Event {
    std::size_t run = 0;
    double time_s = 0.0;  // since the start of the run
  };
  double p_value = 1.0;
  double size = 0.0;           // root mean square of what the events add to a free run in 10 s, m or rad
  double share = 0.0;          // of the power of all windows
  double share_of_time = 0.0;  // of the windows with an event
  // Of the run with the strongest event: time and change of the free-run error, window by window, m or rad.
  std::vector<std::pair<double, double>> changes;
  std::vector<Event> events;  // the strongest first, none within a second of a stronger one of its run
};

// Sums of innovations over windows of 0.3 s, over the square root of their number, scatter with the same
// deviation everywhere where the model is adequate and the noise is the same everywhere. Noise is often
// larger where the robot drives or turns faster, as where the times of poses are not known exactly: windows
// are compared with those in which it was driven as fast, and with those in which it was turned as fast.
// Deviations are taken from median sizes, on which few windows have no influence. An event is a window beyond
// five of the largest of its deviations in which the free-run error changes by `visible` or more. The number
// of events is Poisson with mean windows * P(|z| > 5). None where there are too few windows or no event.
std::optional<IntermittentEvents> intermittent_events(std::span<const ResidualTrack* const> tracks,
                                                      const RecentCommands& commands, double visible);

}  // namespace wheelwright::gap
