// wheelwrightd: a robot on a serial port that calibrates a model of itself and drives from it.
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/exit_status.hpp"
#include "daemon/journal_sink.hpp"
#include "daemon/plan.hpp"
#include "daemon/process.hpp"
#include "daemon/rest.hpp"

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
                 "drive the commands of this drive log as they stand, such as next_experiment.csv of "
                 "'wheelwright gap', instead of calibrating and driving a route");
  app.add_option("--status", options.status_file,
                 "write how things are to this file every second, for 'wheelwright status' (service: "
                 "status.json in its runtime folder)");
  app.add_option("--lateness", options.lateness_file,
                 "write a histogram of the sensor loop's wake-up lateness at the end");
  app.add_flag("--service", options.as_service,
               "as a service: causes of the end told apart by exit status (sysexits.h), messages to the "
               "journal, the robot waited for");
  auto* check = app.add_flag("--check", options.only_check, "only check the configuration");
  app.add_flag("--rest", options.only_rest, "only put the robot's wheels to rest")->excludes(check);
  app.set_version_flag("--version", "wheelwrightd " WHEELWRIGHT_VERSION);
  app.footer("Example:\n  wheelwrightd --config config/wheelwright.yaml --device /dev/ttyUSB0");
}

int refuse(const Options& options, EndCause cause, const std::string& why) {
  std::cerr << (options.as_service ? "<3>" : "") << "wheelwrightd: " << why << '\n';
  return exit_status(cause, options.as_service);
}

void set_up_messages(const Options& options, const wheelwright::config::DaemonConfig& config) {
  if (options.as_service) {
    if (auto journal = daemon::make_journal_sink(
            {{"WHEELWRIGHT_ROBOT", config.robot_name}, {"WHEELWRIGHT_DEVICE", config.device.string()}})) {
      spdlog::set_default_logger(std::make_shared<spdlog::logger>("wheelwrightd", std::move(journal)));
      return;
    }
  }
  const char* no_colour = std::getenv("NO_COLOR");
  const bool plain = no_colour != nullptr && *no_colour != '\0';
  spdlog::set_default_logger(plain ? spdlog::stderr_logger_mt("wheelwrightd")
                                   : spdlog::stderr_color_mt("wheelwrightd"));
  spdlog::set_pattern("%H:%M:%S.%e %^%l%$ %v");
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

EndCause run(const Options& options) {
  const daemon::ProcessOptions process = process_options(options);
  const auto config = daemon::load_configuration(process);
  set_up_messages(options, config);
  if (options.only_rest) {
    daemon::rest_wheels(config);
    return EndCause::done;
  }
  if (options.only_check) {
    daemon::make_plan(config, daemon::known_model(config));
    return EndCause::done;
  }
  return daemon::run_process(process);
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
  try {
    return exit_status(run(options), options.as_service);
  } catch (const daemon::StartFailure& failure) {
    return refuse(options, failure.cause(), failure.what());
  } catch (const std::exception& error) {
    return refuse(options, EndCause::configuration, error.what());
  }
}
