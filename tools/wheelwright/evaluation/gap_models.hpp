// What the gap workflow makes of the robot of an evaluation.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "model/gap/fit/parallel_for.hpp"
#include "tools/wheelwright/evaluation/attempt.hpp"

namespace wheelwright::tools {

struct LearnedGap {
  GapModels models;
  std::string found;  // verdict and names, in one line
};

// The number of an attempt that is none: the robot before all of them.
inline constexpr std::uint64_t before_all_attempts = ~std::uint64_t{0};

// Records drives with reference poses on the plan's robot, planned by `calibrated`, and analyses their gap.
// Or why that was not possible, in one line. Depends on nothing but its arguments.
tl::expected<LearnedGap, std::string> learn_gap_models(const EvaluationPlan& plan, std::uint64_t number,
                                                       const RobotModel& calibrated,
                                                       const gap::ParallelFor& parallel_for);

}  // namespace wheelwright::tools
