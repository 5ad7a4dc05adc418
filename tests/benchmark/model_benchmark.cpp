// Identification and free run.
#include <benchmark/benchmark.h>

#include "model/identification/fir_fit.hpp"
#include "model/prediction/free_run.hpp"
#include "tests/benchmark/plant_log.hpp"

namespace wheelwright::benchmarks {
namespace {

void fit_fir_to_10_minutes(benchmark::State& state) {
  const std::vector<DriveLog> logs{plant_log(600.0)};
  for ([[maybe_unused]] const auto& iteration : state) {
    const auto fit = fit_fir(logs);
    if (!fit) state.SkipWithError("the fit was refused");
    benchmark::DoNotOptimize(fit);
  }
}
BENCHMARK(fit_fir_to_10_minutes)->Unit(benchmark::kSecond);

void free_run_per_sample(benchmark::State& state) {
  const DriveLog log = plant_log(600.0);
  const LinearModel model = plant_model(30);
  for ([[maybe_unused]] const auto& iteration : state) {
    const auto motion = free_run(model, log);
    benchmark::DoNotOptimize(motion.data());
  }
  const auto samples = static_cast<double>(state.iterations()) * static_cast<double>(log.samples.size());
  state.counters["seconds_per_sample"] =
      benchmark::Counter(samples, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(free_run_per_sample)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wheelwright::benchmarks
