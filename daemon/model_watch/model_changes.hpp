// What a gap workflow found to differ from the model in use, in sentences, and whether the new model is
// proven.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

// The answer of `wheelwright gap`, as far as the watch needs it.
struct GapAnswer {
  std::string verdict;
  std::string summary;
  bool differs = false;  // an effect was added, or the linear part of the model in use is off
  // On drives that nothing was fitted to or chosen by, the new model ends nearer, by 3 % at least, and passes
  // the check.
  bool proven = false;
  double untouched_before_m = 0.0;  // error of travel on them
  double untouched_after_m = 0.0;
  struct Detectable {
    std::string effect;
    std::string parameter;
    double size = 0.0;
  };
  std::vector<Detectable> detectable;  // effects that are not there, with the size that would have shown
};

// Sentences such as "coulomb_friction: speed_loss rose from 0.005 to 0.011 m/s since 2026-11-26T14:02Z (95 %:
// 0.009 to 0.013)". An effect that both have counts only where the new interval does not hold the former
// value; one that is gone only where the drives would have shown it.
std::vector<std::string> effect_changes(const RobotModel& before, const RobotModel& after,
                                        const GapAnswer& answer, const std::string& since);

// Reads gap.json; or why it cannot be read.
tl::expected<GapAnswer, std::string> read_gap_answer(const std::filesystem::path& file);

}  // namespace wheelwright::daemon
