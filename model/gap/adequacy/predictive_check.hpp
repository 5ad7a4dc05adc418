// Whether a model is enough: one check on runs that it was not fitted to.
//
// Where the accepted model and its noise are right, the innovations of a run are independent and standard
// normal. Each statistic below looks for one way in which they are not, and comes with the probability of as
// large a value by chance. The check fails if the smallest of all these, corrected for their number (Sidak),
// lies below `level`. A statistic counts only if what it shows would be seen by a person in the free run
// (figures/visible_error.hpp).
//   periodic residual, over time and over a wheel's travel      periodic_residual.hpp
//   dependence on command, heading, place, time, and on the time since a change of command   dependence.hpp
//   offset of measured headings and positions over heading      offset_over_heading.hpp
//   intermittent events                                         intermittent_events.hpp
//   residual after reversals of a wheel                         reversal_residual.hpp
//   drift beyond that of sound robots                           drift.hpp
#pragma once

#include <string>
#include <vector>

#include "model/gap/figures/visible_error.hpp"
#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {

constexpr double check_level = 0.01;

// The curve that shows it to a person.
struct StatisticCurve {
  std::string x_axis;  // with unit: "heading [rad]"
  std::string y_axis;
  std::vector<std::pair<double, double>> points;
};

struct CheckStatistic {
  std::string name;      // "periodic residual, heading"
  double p_value = 1.0;  // of this statistic by itself
  double size = 0.0;     // m or rad
  bool visible = false;
  bool predictable = true;    // false where nothing in the runs says when it comes
  std::string sentence;       // "the error of the heading swings every 1.43 s by 35 mrad to either side"
  std::string regime;         // where: "heading from 1.2 to 2.0 rad"
  double share_of_gap = 0.0;  // of the free-run error
  double share_of_time = 1.0;
  StatisticCurve curve;
  std::vector<std::pair<std::string, double>> detail;  // key with unit, value
};

struct PredictiveCheck {
  bool passed = true;
  double p_value = 1.0;  // of the smallest of the statistics that count
  // Those that count before the others; of those by which the check fails, predictable ones first, which say
  // more; then the most surprising first.
  std::vector<CheckStatistic> statistics;
};

// `problem` holds the untouched runs, under the noise of the training.
PredictiveCheck predictive_check(const FitProblem& problem, const TrialModel& model);

}  // namespace wheelwright::gap
