// What a held command comes to in the end, by a model's effects: how much of a small change of it is seen.
//
// A change of a command beyond a saturation moves nothing, and one inside a dead zone neither. A search for
// what acts on commands weighs its evidence by that.
#pragma once

#include <vector>

#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {

class SteadyResponse {
 public:
  // Of both wheels together, for commands up to this size, either way. A model without effects passes each
  // command on as it is.
  SteadyResponse(const TrialModel& model, double fastest_m_s);

  // The command by which the linear part alone would reach the same wheel speed, m/s.
  double at(double command_m_s) const;
  // What comes of a small change of the command, relative.
  double slope(double command_m_s) const;

 private:
  double apart_m_s_ = 0.0;        // of two commands of the table
  std::vector<double> size_m_s_;  // from the largest backward to the largest forward; empty: as it is
};

}  // namespace wheelwright::gap
