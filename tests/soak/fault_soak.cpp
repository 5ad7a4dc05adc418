// fault_soak: thousands of faults of the cable on the virtual clock. tests/soak/run builds and starts it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "config/load/simulation_config.hpp"
#include "tests/support/soak/virtual_soak.hpp"

namespace {

using namespace wheelwright;

struct Options {
  std::int64_t faults = 2000;
  std::uint64_t seed = 1;
  std::string robot = std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/robots/default.yaml";
  std::vector<std::string> kinds;
  bool stream = false;
};

double resident_megabytes() {
  long total = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return 1e-6 * static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

soak::SoakConfig configured(const Options& options) {
  soak::SoakConfig config;
  config.robot = config::load_simulation_config(options.robot);
  config.robot.room = {};  // an endless floor
  config.robot.seed = options.seed;
  config.cable.seed = options.seed;
  config.faults = options.faults;
  if (options.stream) {
    config.link.transport = roomba::Transport::stream;
    config.link.period_s = config.robot.firmware.sensor_update_period_s;
  }
  for (const std::string& name : options.kinds) {
    const auto kind = simulation::cable_fault_kind(name);
    if (!kind) throw CLI::ValidationError("--kinds", "no fault is called '" + name + "'");
    config.cable.kinds.push_back(*kind);
  }
  return config;
}

int run(const Options& options) {
  soak::SoakConfig config = configured(options);
  const auto started = std::chrono::steady_clock::now();
  double megabytes_early = 0.0;
  const bool on_terminal = ::isatty(STDERR_FILENO) != 0;
  config.progress = [&](std::int64_t faults) {
    if (faults == options.faults / 10) megabytes_early = resident_megabytes();
    if (on_terminal && faults % 20 == 0) {
      std::fprintf(stderr, "\r%lld of %lld faults", static_cast<long long>(faults),
                   static_cast<long long>(options.faults));
    }
  };
  const soak::SoakFigures figures = soak::run_virtual_soak(config);
  if (on_terminal) std::fputs("\r\033[K", stderr);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const double growth = resident_megabytes() - megabytes_early;
  std::fputs(soak::to_text(figures).c_str(), stdout);
  std::printf("  memory: %.1f MB after a tenth, %+.1f MB since; took %.0f s\n", megabytes_early, growth,
              took_s);
  auto wrong = soak::shortcomings(figures);
  if (growth > 2.0) wrong.push_back("memory has grown by more than 2 MB");
  for (const std::string& what : wrong) std::printf("FAILED: %s\n", what.c_str());
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Faults of the cable on the virtual clock, and what link and brain make of them.",
               "fault_soak");
  app.add_option("--faults", options.faults, "how many (2000)")->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "of faults and robot (1)");
  app.add_option("--robot", options.robot, "description of the robot (config/robots/default.yaml)");
  app.add_option("--kinds", options.kinds, "only faults of these kinds, comma separated")->delimiter(',');
  app.add_flag("--stream", options.stream, "by the sensor stream instead of queries");
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fault_soak: %s\n", error.what());
    return 2;
  }
}
