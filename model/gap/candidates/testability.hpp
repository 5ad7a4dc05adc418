// What these logs can show: which effects can be tried at all, and the smallest size of each that would have
// shown.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/gap/candidates/screening.hpp"
#include "model/log/drive_log.hpp"

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

// What the commands ask for, of all runs together.
struct Excitation {
  double reverse_m = 0.0;  // of the wheel that goes backward the most
  double forward_m = 0.0;
  double turned_rad = 0.0;  // both ways
};

struct Testability {
  std::vector<const EffectInfo*> candidate_effects;  // with the decoys that belong to them
  std::vector<Untestable>
      untestable;  // some are candidates all the same: what they do to the wheels may show
  Excitation excitation;
};

// By what the logs hold at all: counts, references, reversals, turns, sizes of command, voltage. Whether
// there is enough of it is not asked here.
Testability testability(std::span<const DriveLog> logs);

// By the information that the runs hold of each absent effect, given the noise and all that the linear part
// takes up: the smallest size that would have shown itself with a probability of 80 %. Effects that no size
// within reason would show are added to `untestable`.
std::vector<Detectable> detectable_sizes(const Screening& look, const Excitation& driven,
                                         double nats_to_be_named, double autocorrelation_factor,
                                         std::vector<Untestable>& untestable);

}  // namespace wheelwright::gap
