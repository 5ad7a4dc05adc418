// The simulator's side of `wheelwright gap`: its runs, given or made, beside those of the robot.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/gap/simulation_gap.hpp"
#include "tools/wheelwright/common/progress_line.hpp"
#include "tools/wheelwright/gap/simulator.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

namespace wheelwright::tools {

struct SimulationInput {
  std::vector<std::string> logs;  // given
  Simulator simulator;            // else run on the commands of the robot's runs
  ImportOptions import;           // of its logs

  bool any() const { return !logs.empty() || !simulator.command.empty(); }
};

struct ComparedSimulation {
  gap::SimulationGap gap;
  // Of the simulator's own runs, where it was run: by the commands of the training runs, and of those that
  // the answer is tested on.
  std::optional<Score> train;
  std::optional<Score> test;
};

// What a simulator writes stays in `folder`. Throws UsageError where runs cannot be had or compared.
ComparedSimulation compare_simulation(const SimulationInput& input, const std::vector<DriveLog>& train,
                                      const std::vector<DriveLog>& test, const std::filesystem::path& folder,
                                      std::ostream& err, ProgressLine& progress);

}  // namespace wheelwright::tools
