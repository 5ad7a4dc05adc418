// A model with effects: one simulated sample.
#include <benchmark/benchmark.h>

#include "model/simulation/model_simulation.hpp"
#include "tests/benchmark/plant_log.hpp"

namespace wheelwright::benchmarks {
namespace {

// Order 9, with one effect before the core, one behind it and one of the body.
void simulated_sample_with_three_effects(benchmark::State& state) {
  const DriveLog log = plant_log(120.0);
  const std::vector<EffectSetting> effects{{"dead_zone", "", {0.01, 0.02}},
                                           {"gain_curve", "command", {0.1, 0.0}},
                                           {"turn_speed_loss", "relative", {0.05, 0.0}}};
  LinearModel linear_part = plant_model(9);
  linear_part.type = ModelType::arma;
  linear_part.left.from_own_past =
      linear_part.right.from_own_past = {0.2, 0.1, 0.05, 0.02, 0.01, 0.01, 0.005, 0.002, 0.001};
  ModelSimulation simulation(linear_part, effects);
  for ([[maybe_unused]] const auto& iteration : state) {
    simulation.reset({});
    for (const auto& sample : log.samples) benchmark::DoNotOptimize(simulation.step(sample.command_m_s));
  }
  const auto samples = static_cast<double>(state.iterations()) * static_cast<double>(log.samples.size());
  state.counters["seconds_per_sample"] =
      benchmark::Counter(samples, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(simulated_sample_with_three_effects)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wheelwright::benchmarks
