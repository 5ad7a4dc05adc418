// roomba-sim: a simulated robot on a pseudo-terminal.
#include <sched.h>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "config/load/drive_log_file.hpp"
#include "config/load/output_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/shipped_folder.hpp"
#include "config/load/simulation_config.hpp"
#include "drivers/simulation/recording.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "drivers/simulation/terminal_server.hpp"

namespace {

namespace simulation = wheelwright::simulation;
namespace config = wheelwright::config;

constexpr int done = 0;
constexpr int bad_usage = 2;

struct Options {
  std::string config;
  std::string room;
  std::string link;
  std::string truth;
  std::string replay;
  std::optional<std::uint64_t> seed;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--config", options.config, "description of the robot (default: robots/default.yaml)");
  app.add_option("--room", options.room, "put the robot into this room instead of its own");
  app.add_option("--link", options.link,
                 "make a symbolic link to the pseudo-terminal (default: print its path)");
  app.add_option("--seed", options.seed, "replaces the seed of the description")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--truth", options.truth, "write the true motion to this CSV file");
  app.add_option("--replay", options.replay,
                 "answer with the counts of this drive log, from the first command to move on");
  app.set_version_flag("--version", "roomba-sim " WHEELWRIGHT_VERSION);
  app.footer(
      "Runs until SIGTERM or SIGINT. SIGUSR1 takes the battery out, and puts it in again.\n"
      "\n"
      "Example:\n"
      "  roomba-sim --config config/robots/default.yaml --link /tmp/roomba --truth /tmp/truth.csv &\n"
      "  wheelwrightd --config config/wheelwright.yaml --device /tmp/roomba");
}

simulation::SimulatedRobot make_robot(const simulation::SimulationConfig& robot, const std::string& replay) {
  if (replay.empty()) return simulation::SimulatedRobot(robot);
  return {robot, simulation::recording_of(config::load_drive_log(replay))};
}

// A robot answers in time however busy the host is; where the system allows it, so does this one.
void take_precedence() {
  sched_param parameters{};
  parameters.sched_priority = 60;
  ::sched_setscheduler(0, SCHED_FIFO, &parameters);
}

int run(const Options& options) {
  auto robot_config =
      config::load_simulation_config(options.config.empty() ? config::shipped_folder() / "robots/default.yaml"
                                                            : std::filesystem::path(options.config));
  if (!options.room.empty()) robot_config.room = config::load_room(options.room);
  if (options.seed) robot_config.seed = *options.seed;
  auto robot = make_robot(robot_config, options.replay);

  std::optional<simulation::TruthFile> truth;
  if (!options.truth.empty()) {
    const auto file = config::open_output({options.truth, config::OutputKind::truth},
                                          {options.config, options.room, options.replay});
    if (!file) throw std::runtime_error(file.error());
    truth = simulation::TruthFile{*file, robot_config.firmware.tick_s};
  }
  simulation::PseudoTerminal terminal;
  std::unique_ptr<simulation::TerminalLink> link;
  if (options.link.empty()) {
    std::cout << terminal.path() << std::endl;  // whoever started us waits for this line
  } else {
    link = std::make_unique<simulation::TerminalLink>(options.link, terminal.path());
    std::cout << "the robot answers on " << config::printable(options.link) << " (" << terminal.path()
              << "); Ctrl-C ends it" << std::endl;
  }
  take_precedence();
  simulation::serve_until_signal(robot, terminal, truth);
  return done;
}

std::string first_line(const std::string& text) {
  return config::printable(text.substr(0, text.find('\n')));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A simulated Roomba that speaks the Open Interface on a pseudo-terminal.", "roomba-sim");
  describe(app, options);
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    std::cerr << "roomba-sim: " << first_line(error.what()) << "; try --help\n";
  } catch (const std::exception& error) {
    std::cerr << "roomba-sim: " << first_line(error.what()) << '\n';
  }
  return bad_usage;
}
