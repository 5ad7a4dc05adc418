// Measured minus predicted, in every channel that a run has.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/gap/fit/trial_model.hpp"
#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

// A segment between two references that lie far apart: errors of the second pose seen from the first. Of
// headings alone the other two are zero.
struct SegmentError {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;
};

struct RunErrors {
  std::array<std::vector<double>, channel_count> series;  // one per reading
  std::vector<SegmentError> segments;                     // of a sparse run
  double gyro_drift_rad_s = 0.0;                          // taken out of `turn` where that is a gyro's
};

// Fills the measured values of the channels forward, aside and turn. They are what the references have beyond
// odometry where there are counts, and the whole motion where there are none.
void measure_motion(GapRun& run);

// Outputs of a model that a parameter affects. With counts there are two kinds, which hardly depend on each
// other: what the wheels do at their commands, and the motion beyond odometry, that the floor makes of the
// wheels' travel. A parameter of the motion does not affect the wheels. One of the wheels does not affect the
// motion unless some effect makes another motion of the wheels' travel.
enum class Outputs { all, wheels, motion };

// A simulation, and how measurements relate to it.
struct MeasuredSimulation {
  ModelSimulation simulation;
  bool by_pose = false;         // some effect acts by place or heading
  bool by_wheel_angle = false;  // some effect acts by the angle of a wheel
  double reference_lag_s = 0.0;
  double gyro_scale = 0.0;  // relative, by how much the gyro says too much
};
MeasuredSimulation measured_simulation(const TrialModel& model);

// Free run over the run's commands. Channels of other outputs stay empty.
RunErrors free_run_errors(MeasuredSimulation model, const GapRun& run, Outputs outputs = Outputs::all);
RunErrors free_run_errors(const TrialModel& model, const GapRun& run, Outputs outputs = Outputs::all);

// Travel that was measured for each metre that the model predicts, of each wheel (without counts: of the
// body, twice), over windows of a second. 1 where the model's gain is right.
WheelPair travel_gain(const TrialModel& model, const GapRun& run);

// What a model's free run shows period by period, for tables and plots.
struct ModelState {
  WheelPair wheel_m_s;
  Twist twist;
  Pose pose;
  WheelPair distance_m;
};
std::vector<ModelState> model_states(const TrialModel& model, const GapRun& run);

}  // namespace wheelwright::gap
