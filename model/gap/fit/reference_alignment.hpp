// What an analysis found of the references of a log: needed before figures of them are computed or drawn.
#pragma once

#include "model/gap/fit/trial_model.hpp"
#include "model/gap/runs/run.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// Notes how late the references are. Where a gyro stands in for them, it is put in their place, without the
// drift that it has beside this model, and by its true scale. `run` is made of `log`.
void note_references(DriveLog& log, const GapRun& run, const TrialModel& model);

}  // namespace wheelwright::gap
