// What the gap workflow makes of the robot of an evaluation, before its attempts.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "tools/wheelwright/evaluation/attempt.hpp"

namespace wheelwright::tools {

struct LearnedGap {
  GapModels models;
  std::string found;  // verdict and names, in one line
};

// Calibrates the plan's robot, records drives with reference poses on it, and analyses their gap: once, with
// luck of its own. Or why that was not possible, in one line. Depends on nothing but the plan.
tl::expected<LearnedGap, std::string> learn_gap_models(const EvaluationPlan& plan);

}  // namespace wheelwright::tools
