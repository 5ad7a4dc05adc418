// wheelwrightd: a robot on a serial port that calibrates a model of itself and drives from it.
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/process.hpp"

namespace {

constexpr int exit_bad_input = 2;

int refuse(const std::string& why) {
  std::cerr << "wheelwrightd: " << why << '\n';
  return exit_bad_input;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Calibrates a differential-drive robot and drives routes from its model.", "wheelwrightd"};
  app.footer("Example:\n  wheelwrightd --config config/wheelwright.yaml --device /dev/ttyUSB0");
  std::string config_file;
  std::string device;
  std::string lateness_file;
  app.add_option("--config", config_file, "configuration (config/wheelwright.yaml shows every key)")
      ->required();
  app.add_option("--device", device, "serial port of the robot, instead of link.device");
  app.add_option("--lateness", lateness_file,
                 "write a histogram of the sensor loop's wake-up lateness at the end");
  app.set_version_flag("--version", "wheelwrightd " WHEELWRIGHT_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return refuse(std::string(error.what()) + "; see wheelwrightd --help");
  }
  try {
    auto config = wheelwright::config::load_daemon_config(config_file);
    if (!device.empty()) config.device = device;
    spdlog::set_default_logger(spdlog::stderr_color_mt("wheelwrightd"));
    spdlog::set_pattern("%H:%M:%S.%e %^%l%$ %v");
    return wheelwright::daemon::run_process(config, lateness_file);
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
