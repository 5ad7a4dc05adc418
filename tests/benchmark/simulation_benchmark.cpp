// How much faster than the clock the simulated robot runs, alone and with the whole daemon's brain at the
// other end of its line.
#include <benchmark/benchmark.h>

#include "config/load/route_file.hpp"
#include "config/load/simulation_config.hpp"
#include "daemon/replay/virtual_run.hpp"
#include "drivers/open_interface/commands.hpp"
#include "tests/benchmark/plant_log.hpp"

namespace wheelwright::benchmarks {
namespace {

const std::filesystem::path source_folder = WHEELWRIGHT_SOURCE_DIR;

simulation::SimulationConfig robot_in_empty_room() {
  auto config = config::load_simulation_config(source_folder / "config/robots/default.yaml");
  config.room = config::load_room(source_folder / "config/robots/rooms/empty.yaml");
  return config;
}

void set_rate(benchmark::State& state, double simulated_s) {
  state.counters["robot_seconds_per_second"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}

void simulate_robot(benchmark::State& state) {
  using namespace std::chrono_literals;
  simulation::SimulatedRobot robot(robot_in_empty_room());
  open_interface::CommandBytes bytes;
  bytes.start();
  bytes.safe_mode();
  bytes.drive_direct(200, 180);
  robot.receive(bytes.bytes());
  for ([[maybe_unused]] const auto& iteration : state) robot.advance(1s);
  set_rate(state, static_cast<double>(state.iterations()));
}
BENCHMARK(simulate_robot)->Unit(benchmark::kMillisecond);

void simulate_robot_and_daemon(benchmark::State& state) {
  daemon::VirtualRunConfig run;
  run.mission.route = config::load_route(source_folder / "config/routes/square.yaml");
  run.model.emplace();
  run.model->linear_part = plant_model(30);
  double simulated_s = 0.0;
  for ([[maybe_unused]] const auto& iteration : state) {
    simulation::SimulatedRobot robot(robot_in_empty_room());
    const auto result = daemon::run_virtually(run, robot);
    if (!result.finished) state.SkipWithError("the route was not finished");
    simulated_s += result.duration_s;
  }
  set_rate(state, simulated_s);
}
BENCHMARK(simulate_robot_and_daemon)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wheelwright::benchmarks
