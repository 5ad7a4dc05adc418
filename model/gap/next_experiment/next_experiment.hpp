// The drive to record next: of a menu of short and safe ones, the one on which the answers that are still
// possible would part the most.
//
// Each possible answer is a model. One of them is taken for the truth and drives the manoeuvre; the other is
// fitted to that as well as it can be, without giving up what the runs so far have taught it (their
// information stands for them); what then still lies between the two, in units of the noise that was found,
// is how well the manoeuvre tells them apart. The manoeuvre with the largest worst pair is taken:
// T-optimality (Atkinson and Fedorov, "The design of experiments for discriminating between two rival
// models", Biometrika 62 (1975) 57-70), with the refit linearised.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/conclusion/analysis_result.hpp"
#include "model/gap/next_experiment/manoeuvres.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

struct NextExperiment {
  std::string manoeuvre;                    // as a person says it
  DriveLog commands;                        // to be driven: no measurement in it
  std::array<std::string, 2> separates;     // the pair that it tells apart the least; "nothing" for no effect
  double nats = 0.0;                        // of log likelihood by which it tells these two apart
  double seconds = 0.0;                     // that it takes
  std::vector<std::string> makes_testable;  // effects that the runs so far could not show
};

// Where rivals remain, what separates them; else, where effects could not be tested for lack of reversals,
// turns or variety, what shows the most of them. Nothing where neither is so, or where no manoeuvre within
// the limits helps. `train` are the logs that the analysis was made from.
std::optional<NextExperiment> next_experiment(const GapAnalysis& analysis, std::span<const DriveLog> train,
                                              const ManoeuvreLimits& limits, const ParallelFor& parallel_for);

// The limits that the logs themselves suggest: no faster and no harder than the robot was driven there.
ManoeuvreLimits limits_of(std::span<const DriveLog> logs);

}  // namespace wheelwright::gap
