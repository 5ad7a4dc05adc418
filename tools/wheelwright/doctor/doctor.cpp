// wheelwright doctor: looks at a robot and at this machine, and says whether one can drive the other.
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <ostream>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/doctor/encoder_trial.hpp"
#include "tools/wheelwright/doctor/examination.hpp"
#include "tools/wheelwright/doctor/finding.hpp"
#include "tools/wheelwright/doctor/interruption.hpp"

namespace wheelwright::tools {
namespace {

struct DoctorOptions {
  std::string device;
  std::string config;
  bool move = false;
  bool json = false;
};

bool wants_colour() {
  const char* const no_colour = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0');
}

// One line that replaces itself, and is gone in the end.
doctor::Progress progress_on(std::ostream& err) {
  if (::isatty(STDERR_FILENO) != 1) return [](const std::string&) {};
  return [&err](const std::string& what) {
    err << "\r\033[K" << (what.empty() ? "" : "  " + config::printable(what) + " ...") << std::flush;
  };
}

ExitStatus run_doctor(const DoctorOptions& options, Streams streams) {
  auto config = options.config.empty() ? config::DaemonConfig{} : config::load_daemon_config(options.config);
  if (!options.device.empty()) config.device = options.device;
  const auto progress = progress_on(streams.err);
  std::vector<doctor::Finding> findings;
  try {
    const doctor::InterruptionWatch watch;
    findings = doctor::examine(config, options.move, progress);
  } catch (const std::exception& error) {
    progress("");
    if (dynamic_cast<const doctor::Interrupted*>(&error) != nullptr) throw DataRefusal(error.what());
    throw;
  }
  progress("");
  if (options.json) {
    doctor::print_json(streams.out, config.device.string(), findings);
  } else {
    doctor::print_report(streams.out, findings, wants_colour());
  }
  return doctor::verdict_on(findings).fit_to_drive ? ExitStatus::done : ExitStatus::answer_is_no;
}

}  // namespace

Action add_doctor(CLI::App& app) {
  const auto options = std::make_shared<DoctorOptions>();
  CLI::App* command =
      app.add_subcommand("doctor", "Checks this machine and its robot, and says what to mend");
  command->add_option("--device", options->device,
                      "Serial port of the robot (default: link.device of the configuration, /dev/roomba)");
  command->add_option("--config", options->config,
                      "The daemon's configuration, to judge against its settings");
  command->add_flag(
      "--move", options->move,
      "Also find out which encoder is which: turns the left wheel 25 mm and back, in Safe mode");
  command->add_flag("--json", options->json, "The findings as JSON");
  command->footer(
      "Takes about 10 s. Moves nothing unless asked to; leaves the robot at rest in Passive mode.\n"
      "Exit status: 0 fit to drive, 1 not, 2 bad usage or the device cannot be opened.\n"
      "Example: wheelwright doctor --device /dev/ttyUSB0 --move");
  return [options](Streams streams) { return run_doctor(*options, streams); };
}

}  // namespace wheelwright::tools
