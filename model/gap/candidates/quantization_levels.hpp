// The step in which commands act, where they do: found by what rounding leaves in the wheels' speeds.
//
// A step that is half a percent off rounds large commands the other way, so that a fit finds the right one
// only from very near. Whole fits at that many steps would take minutes; but what rounding changes is small
// and passes the linear part like any command. So the linear part's answer is turned round once
// (correlation of the residual speeds with the linear part's impulse response), and then each step costs a
// sum of products.
#pragma once

#include <algorithm>
#include <optional>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Commands act as multiples of a step; at `level_edges` of a step beyond one, they act as the next.
struct CommandSteps {
  double step_m_s;
  double level_edges;
};

// The largest that is tried: with larger ones a fast robot would have fewer than three speeds.
inline double largest_command_step_m_s(double fastest_m_s) {
  return std::max(0.1, fastest_m_s / 3.0);
}

// The step that stands out of all that were tried, and where it rises; nothing where none does, or where
// these runs show no speeds (no counts, and poses only now and then). `fit` is the model without the effect,
// `info` is command_quantization.
std::optional<TrialEffect> find_command_steps(const FitProblem& train, const Fit& fit, const EffectInfo& info,
                                              const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
