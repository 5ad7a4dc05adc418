#include "model/gap/fit/reference_alignment.hpp"

#include "model/gap/fit/free_run_errors.hpp"
#include "model/gap/runs/gyro_turns.hpp"

namespace wheelwright::gap {

void note_references(DriveLog& log, const GapRun& run, const TrialModel& model) {
  log.references_late_s = model.reference_lag_s();
  if (!run.by_gyro || !run.references.empty() || model.linear_part.empty()) return;
  const double drift_rad_s = free_run_errors(model, run, Outputs::motion).gyro_drift_rad_s;
  lay_gyro_headings(log, drift_rad_s, model.gyro_scale());
}

}  // namespace wheelwright::gap
