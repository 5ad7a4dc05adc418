// The step in which commands act, where hardly a command is given twice: a sine, a ramp, a joystick.
//
// Rounding is a sawtooth over the command, and repeats with the step. Each step is tried by the first
// harmonic of that, as the linear part passes it on: its size and phase are linear in what the model
// leaves, and the phase tells where the steps rise.
#pragma once

#include <optional>

#include "model/gap/candidates/quantization_levels.hpp"

namespace wheelwright::gap {

// As find_command_steps, which it stands behind.
std::optional<CommandSteps> find_steps_by_spectrum(const FitProblem& train, const Fit& fit,
                                                   const EffectInfo& info, const ParallelFor& parallel_for);

}  // namespace wheelwright::gap
