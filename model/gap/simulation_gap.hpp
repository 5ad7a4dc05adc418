// The gap between a simulator and a robot: runs of both, each identified as a model with effects. The gap is
// that of the simulator's model on the robot's runs.
#pragma once

#include <string>
#include <vector>

#include "model/gap/analysis.hpp"
#include "model/gap/simulation/differences.hpp"

namespace wheelwright::gap {

struct SimulationGap {
  GapAnalysis robot;  // `found`: what the simulation lacks or has in another size; `before`: the simulation
  GapAnalysis simulation;
  std::vector<EffectDifference> differences;
  std::vector<std::string> remarks;  // on the simulation's runs, a sentence each
};

// The commands need not be the same, nor the periods. Refuses runs of the simulation that contradict
// themselves or show nothing, and whatever analyse_gap refuses.
tl::expected<SimulationGap, GapRefusal> analyse_simulation_gap(std::span<const DriveLog> simulated,
                                                               std::span<const DriveLog> train,
                                                               std::span<const DriveLog> test,
                                                               const ParallelFor& parallel_for,
                                                               const Progress& progress);

// The simulator itself on the commands of the robot's runs, by its free runs over those of training and of
// `check`. An answer that this contradicts is corrected: nothing is not missing where the simulator is off by
// more than noise. Where it is as near as noise allows, the summary says so.
void hold_against_simulator(SimulationGap& gap, const Score& train, const Score& test);

}  // namespace wheelwright::gap
