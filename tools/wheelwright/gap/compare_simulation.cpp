#include "tools/wheelwright/gap/compare_simulation.hpp"

#include <algorithm>
#include <ostream>

#include "model/gap/data_checks/informative_segments.hpp"
#include "model/gap/simulation/simulated_motion.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"
#include "tools/wheelwright/gap/simulated_run.hpp"

namespace wheelwright::tools {
namespace {

std::vector<DriveLog> runs_of_simulator(const SimulationInput& input, const std::vector<DriveLog>& real,
                                        const std::filesystem::path& folder, std::ostream& err,
                                        ProgressLine& progress) {
  const auto say = progress.callback();
  const auto files = run_simulator(input.simulator, real, folder, [&](std::size_t run) {
    say("simulator, run " + std::to_string(run + 1) + " of " + std::to_string(real.size()), 0.0);
  });
  std::vector<DriveLog> simulated;
  for (std::size_t run = 0; run < files.size(); ++run) {
    simulated.push_back(load_simulated_run(files[run], real[run], input.import, err));
  }
  return simulated;
}

std::vector<DriveLog> runs_of_simulation(const SimulationInput& input, std::ostream& err,
                                         ProgressLine& progress) {
  auto runs = load_all_runs({input.logs, input.import}, err, progress);
  for (const DriveLog& run : runs) check_simulation_run(run, err);
  return gap::informative_segments(std::move(runs), {}).runs;
}

// Of those runs whose names are among the tested ones, or are not.
Score score_of(const std::vector<DriveLog>& simulated, const std::vector<DriveLog>& real,
               const std::vector<std::string>& tested, bool are_tested) {
  std::vector<DriveLog> by_simulator;
  std::vector<DriveLog> by_robot;
  for (std::size_t run = 0; run < real.size(); ++run) {
    if ((std::ranges::find(tested, real[run].name) != tested.end()) != are_tested) continue;
    by_simulator.push_back(simulated[run]);
    by_robot.push_back(real[run]);
  }
  return gap::score_of_simulation(by_simulator, by_robot);
}

}  // namespace

ComparedSimulation compare_simulation(const SimulationInput& input, const std::vector<DriveLog>& train,
                                      const std::vector<DriveLog>& test, const std::filesystem::path& folder,
                                      std::ostream& err, ProgressLine& progress) {
  std::vector<DriveLog> real = train;
  real.insert(real.end(), test.begin(), test.end());
  const bool made = input.logs.empty();
  const std::vector<DriveLog> simulated =
      made ? runs_of_simulator(input, real, folder, err, progress) : runs_of_simulation(input, err, progress);
  auto gap = gap::analyse_simulation_gap(simulated, train, test, parallel_for(), progress.callback());
  if (!gap) throw UsageError(gap.error().reason);
  ComparedSimulation result{*std::move(gap), std::nullopt, std::nullopt};
  if (!made) return result;
  const std::vector<std::string>& tested = result.gap.robot.tested;
  result.train = score_of(simulated, real, tested, false);
  result.test = score_of(simulated, real, tested, true);
  gap::hold_against_simulator(result.gap, *result.train, *result.test);
  return result;
}

}  // namespace wheelwright::tools
