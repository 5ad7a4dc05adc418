#include "tools/wheelwright/gap/compare_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/load/text_format.hpp"
#include "model/gap/data_checks/informative_segments.hpp"
#include "model/gap/simulation/simulated_motion.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/parallel_for.hpp"

namespace wheelwright::tools {
namespace {

double duration_s(const DriveLog& log) {
  return log.samples.back().t_s - log.samples.front().t_s;
}

bool tells_motion(const DriveSample& sample) {
  return sample.ticks || sample.reference_x_m || sample.reference_theta_rad;
}

// A simulation that diverges leaves rows without numbers, or places where no robot comes.
void check_simulated(const DriveLog& simulated, const DriveLog& real) {
  constexpr double min_share = 0.9;
  constexpr double farthest_m = 1e4;
  const std::string beside =
      ", but the commands of " + real.name + " last " + config::fixed_number(duration_s(real), 1) + " s";
  const double min_s = min_share * duration_s(real);
  if (duration_s(simulated) < min_s) {
    throw UsageError(simulated.name + ": ends after " + config::fixed_number(duration_s(simulated), 1) +
                     " s" + beside);
  }
  double told_s = 0.0;
  for (const DriveSample& sample : simulated.samples) {
    const double time_s = sample.t_s - simulated.samples.front().t_s;
    if (tells_motion(sample)) told_s = time_s;
    const double far_m = std::hypot(sample.reference_x_m.value_or(0.0), sample.reference_y_m.value_or(0.0));
    if (far_m <= farthest_m) continue;
    throw UsageError(simulated.name + ": after " + config::fixed_number(time_s, 1) + " s the robot is " +
                     config::plain_number(far_m) + " m away; the simulation diverges");
  }
  if (told_s < min_s) {
    throw UsageError(simulated.name + ": neither poses nor counts after " + config::fixed_number(told_s, 1) +
                     " s" + beside);
  }
}

std::vector<DriveLog> runs_of_simulator(const SimulationInput& input, const std::vector<DriveLog>& real,
                                        const std::filesystem::path& folder, std::ostream& err,
                                        ProgressLine& progress) {
  const auto say = progress.callback();
  const auto files = run_simulator(input.simulator, real, folder, [&](std::size_t run) {
    say("simulator, run " + std::to_string(run + 1) + " of " + std::to_string(real.size()), 0.0);
  });
  std::vector<DriveLog> simulated;
  for (std::size_t run = 0; run < files.size(); ++run) {
    simulated.push_back(load_one_run({{files[run]}, input.import}, err));
    check_simulated(simulated.back(), real[run]);
  }
  return simulated;
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
      made ? runs_of_simulator(input, real, folder, err, progress)
           : gap::informative_segments(load_all_runs({input.logs, input.import}, err, progress), {}).runs;
  auto gap = gap::analyse_simulation_gap(simulated, train, test, parallel_for(), progress.callback());
  if (!gap) throw UsageError(gap.error().reason);
  ComparedSimulation result{*std::move(gap), std::nullopt, std::nullopt};
  if (!made) return result;
  const std::vector<std::string>& tested = result.gap.robot.tested;
  result.train = score_of(simulated, real, tested, false);
  result.test = score_of(simulated, real, tested, true);
  return result;
}

}  // namespace wheelwright::tools
