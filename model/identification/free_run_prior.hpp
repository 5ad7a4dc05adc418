// What is believed of a wheel before any data, as equations beside those of a free run.
//
//   * Its impulse responses are smooth and fade (ResponsePrior): h_i - h_(i+1) are independent with variance
//     size * (decay^i - decay^(i+1)).
//   * Its weights of past speeds are of moderate size.
#pragma once

#include <functional>

#include <Eigen/Core>

#include "model/identification/free_run_refinement.hpp"

namespace wheelwright {

using RowSink = std::function<void(const Eigen::RowVectorXd& row)>;

// Rows of unit variance: sensitivities to the unknowns of the layout (where wanted), then what is to be made
// small.
void for_each_prior_row(const FreeRunProblem& problem, const WheelResponse& response, bool with_sensitivities,
                        const RowSink& sink);

}  // namespace wheelwright
