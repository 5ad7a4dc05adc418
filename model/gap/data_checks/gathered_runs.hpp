// The logs of one analysis: whether they belong together, what the data gate leaves of them, and which runs
// are held out.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "model/gap/runs/run_set.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// Where the logs themselves cannot be used: file, line, and what would be right.
struct GapRefusal {
  std::string reason;
};

struct GatheredRuns {
  RunSet train;
  RunSet test;       // held out: what is accepted has to explain these, too
  RunSet untouched;  // for the accepted model alone; empty where there are too few runs to keep one apart
  std::vector<DriveLog> to_learn_from;  // all that were given for it, those held out of them among them
  bool tail_held_out = false;           // a single run: its last third stands in for a run of its own
  std::vector<DataFault> faults;
  std::vector<Dropout> dropouts;
  double watched_s = 0.0;  // all runs together
};

// Three training runs or more, and all of `test` stays untouched: the last third of the training runs is held
// out. Four or more without `test`: the last one stays untouched. With fewer, `test` itself is held out, or
// without it the last third of the runs, or the last third of a single run. All get the grid
// of `period_s`, else of the shortest period. Refuses logs whose periods are not near, of different wheel
// bases or sensors, and such as are too short.
std::optional<GapRefusal> gather_runs(std::span<const DriveLog> train, std::span<const DriveLog> test,
                                      std::optional<double> period_s, GatheredRuns& gathered);

}  // namespace wheelwright::gap
