// wheelwrightd: a robot on a serial port that calibrates a model of itself and drives from it.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <string>

#include "config/load/daemon_config.hpp"
#include "config/load/printable_text.hpp"
#include "daemon/guardian/rest.hpp"
#include "daemon/output_checks.hpp"
#include "daemon/process.hpp"
#include "daemon/service/exit_status.hpp"
#include "daemon/service/message_output.hpp"
#include "daemon/threads/real_time_setup.hpp"
#include "daemon/wiring/plan.hpp"

namespace {

namespace daemon = wheelwright::daemon;
using daemon::EndCause;

struct Options {
  std::string config_file;
  std::string device;
  std::string commands_file;
  std::string lateness_file;
  std::string status_file;
  bool as_service = false;
  bool only_check = false;
  bool only_rest = false;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--config", options.config_file, "configuration (config/wheelwright.yaml shows every key)")
      ->required();
  app.add_option("--device", options.device, "serial port of the robot, instead of link.device");
  app.add_option("--commands", options.commands_file,
                 "drive the commands of this drive log unchanged, such as next_experiment.csv of "
                 "'wheelwright gap', instead of calibrating and driving a route");
  app.add_option("--status", options.status_file,
                 "write the status to this file every second, for 'wheelwright status' (service: "
                 "status.json in its runtime folder)");
  app.add_option("--lateness", options.lateness_file,
                 "write a histogram of the sensor loop's wake-up lateness at the end");
  app.add_flag("--service", options.as_service,
               "as a service: each cause of the end has its exit status (sysexits.h), messages to the "
               "journal, the robot waited for");
  auto* check = app.add_flag("--check", options.only_check, "only check the configuration");
  app.add_flag("--rest", options.only_rest, "only put the robot's wheels to rest")->excludes(check);
  app.set_version_flag("--version", "wheelwrightd " WHEELWRIGHT_VERSION);
  app.footer("Example:\n  wheelwrightd --config config/wheelwright.yaml --device /dev/ttyUSB0");
}

constexpr auto print_patience = std::chrono::seconds(1);

int refuse(const Options& options, EndCause cause, const std::string& why) {
  const std::string line =
      (options.as_service ? "<3>" : "") + ("wheelwrightd: " + wheelwright::config::printable(why)) + "\n";
  daemon::print_within(print_patience, STDERR_FILENO, line);
  return exit_status(cause, options.as_service);
}

daemon::ProcessOptions process_options(const Options& options) {
  daemon::ProcessOptions result{options.config_file,   options.device,      options.commands_file,
                                options.lateness_file, options.status_file, options.as_service};
  const char* folder = std::getenv("RUNTIME_DIRECTORY");
  if (options.as_service && options.status_file.empty() && folder != nullptr) {
    result.status_file = std::filesystem::path(folder) / "status.json";
  }
  return result;
}

// Nothing but the device has to be known, and a mistake in the configuration is no reason to let the wheels
// turn.
EndCause rest(const Options& options) {
  const char* folder = std::getenv("RUNTIME_DIRECTORY");
  const std::filesystem::path runtime_folder(folder == nullptr ? "" : folder);
  const auto targets = daemon::rest_targets(runtime_folder, options.config_file, options.device);
  // An adapter that was unplugged has ended the service, and is nothing to report.
  if (daemon::rest_after_end(runtime_folder, targets) || options.as_service) return EndCause::done;
  throw daemon::StartFailure(EndCause::no_device,
                             targets.front().device.string() +
                                 ": no such device, and so no robot to put to rest; name it with --device");
}

EndCause run(const Options& options) {
  if (options.only_rest) return rest(options);
  const daemon::ProcessOptions process = process_options(options);
  const auto config = daemon::load_configuration(process);
  if (options.only_check) {
    daemon::make_plan(config, daemon::known_model(config));
    daemon::check_daemon_outputs(config, process);
    return EndCause::done;
  }
  daemon::set_up_allocation();
  daemon::set_up_messages(config, options.as_service);
  return daemon::run_process(process);
}

int run_and_explain(const Options& options) {
  try {
    return exit_status(run(options), options.as_service);
  } catch (const daemon::StartFailure& failure) {
    return refuse(options, failure.cause(), failure.what());
  } catch (const std::bad_alloc&) {
    return refuse(options, EndCause::internal, "no memory left; raise its limit (ulimit -v, MemoryMax=)");
  } catch (const std::exception& error) {
    return refuse(options, EndCause::configuration, error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Calibrates a differential-drive robot and drives routes from its model.", "wheelwrightd"};
  Options options;
  describe(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return refuse(options, EndCause::usage, std::string(error.what()) + "; see wheelwrightd --help");
  }
  const int status = run_and_explain(options);
  if (!daemon::drain_messages()) ::_exit(status);
  return status;
}
