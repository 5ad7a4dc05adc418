#include "model/identification/free_run_prior.hpp"

#include <cmath>

#include "model/identification/filtered_run.hpp"
#include "model/identification/settled_response.hpp"

namespace wheelwright {
namespace {

constexpr double past_weight_deviation = 0.3;  // of what is believed of a weight of a past speed

// Many recursions have the same free run: a pole and a zero that cancel change nothing. Of those the one with
// small weights of the past is wanted, for a hybrid filter feeds measured speeds into them, with their noise.
void recursion_rows(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                    const RowSink& sink) {
  const Eigen::Index columns = with_sensitivities ? problem.layout.columns() : 0;
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(columns + 1);
  for (std::size_t i = 0; i < response.from_own_past.size(); ++i) {
    const Eigen::Index column = problem.layout.command_columns() + static_cast<Eigen::Index>(i);
    if (with_sensitivities) row[column] = 1.0 / past_weight_deviation;
    row[columns] = -response.from_own_past[i] / past_weight_deviation;
    sink(row);
    if (with_sensitivities) row[column] = 0.0;
  }
}

// What the prior has to say against an impulse response, as rows of unit variance. Under it h_i - h_(i+1) are
// independent with variance size * (decay^i - decay^(i+1)), and the last h is so with what is left.
void impulse_rows(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                  const RowSink& sink) {
  if (!problem.prior) return;
  const Eigen::Index columns = with_sensitivities ? problem.layout.columns() : 0;
  Eigen::RowVectorXd row(columns + 1);
  Eigen::RowVectorXd next(columns + 1);
  for (const WheelSide driven : {WheelSide::left, WheelSide::right}) {
    TravelRun impulse;
    impulse.commands_m_s.resize(forgetting_periods);
    (driven == WheelSide::left ? impulse.commands_m_s[0].left : impulse.commands_m_s[0].right) = 1.0;
    const FilteredRun filtered(impulse, response, problem.layout, problem.period_s, with_sensitivities);
    const double size = driven == problem.side ? problem.prior->own_size : problem.prior->cross_size;
    double variance = size;  // of h_i
    next.setZero();
    for (std::size_t i = 0; i < forgetting_periods; ++i) {
      const auto value_at = [&](std::size_t period, Eigen::RowVectorXd& into) {
        if (with_sensitivities) filtered.speed_sensitivities(period, into);
        into[columns] = -filtered.speed_m_s(period);
      };
      value_at(i, row);
      double step_variance = variance;
      if (i + 1 < forgetting_periods) {
        value_at(i + 1, next);
        row -= next;
        step_variance *= 1.0 - problem.prior->decay;
      }
      row /= std::sqrt(step_variance);
      sink(row);
      variance *= problem.prior->decay;
    }
  }
}

}  // namespace

void for_each_prior_row(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                        const RowSink& sink) {
  recursion_rows(problem, response, with_sensitivities, sink);
  impulse_rows(problem, response, with_sensitivities, sink);
}

}  // namespace wheelwright
