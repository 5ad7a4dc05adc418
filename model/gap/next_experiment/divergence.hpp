// What a drive would tell between two possible answers, before anybody drives it.
#pragma once

#include <string>

#include <Eigen/Core>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/next_experiment/manoeuvres.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

// One possible answer.
struct Hypothesis {
  std::string name;
  TrialModel model;
  Eigen::MatrixXd information;  // on its parameters, of the runs so far
};

// What a robot records. A further drive is thought to record the same as those so far.
struct Sensors {
  bool counts = false;
  std::size_t reference_every = 0;  // periods; 0 for none
};

Sensors sensors_of(const GapRun& run);

// A manoeuvre as a log without measurements, at the model's period and wheel base.
DriveLog commands_of(const Manoeuvre& manoeuvre, const TrialModel& model);

// The log that a robot of this model would leave of these commands, without noise.
DriveLog driven_by(const TrialModel& truth, DriveLog log, const Sensors& sensors);

// Whether the middle of the axle stays within the circle around its start.
bool stays_inside(const TrialModel& model, const DriveLog& log, double radius_m);

// Nats of log likelihood by which `truth` stays more likely than `other` after a drive, when `other` may
// adapt as far as the runs so far (its information) let it.
double divergence(const Hypothesis& truth, const Hypothesis& other, const DriveLog& commands,
                  const Sensors& sensors, const NoiseModel& noise);

}  // namespace wheelwright::gap
