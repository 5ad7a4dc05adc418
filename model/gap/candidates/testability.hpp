// What these logs can show: which effects can be tried at all, and the smallest size of each that would have
// shown.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/drive_log.hpp"
#include "model/gap/candidates/screening.hpp"

namespace wheelwright::gap {

struct Untestable {
  std::string effect;
  std::string why;
};

struct Detectable {
  std::string effect;
  std::string parameter;
  std::string unit;
  double size = 0.0;
};

struct Testability {
  std::vector<const EffectInfo*> candidates;  // with the decoys that belong to them
  std::vector<Untestable>
      untestable;  // some are candidates all the same: what they do to the wheels may show
};

// By what the logs hold: counts, references, reversals, turns, voltage.
Testability testability(std::span<const DriveLog> logs);

// By what the search saw: the smallest size of each absent effect that would have shown itself with a
// probability of 80 %. Effects that no size within reason would show are added to `untestable`.
std::vector<Detectable> detectable_sizes(const Screening& look, double nats_to_be_named, double inflation,
                                         std::vector<Untestable>& untestable);

}  // namespace wheelwright::gap
