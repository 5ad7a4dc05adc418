#include "daemon/output_checks.hpp"

#include <vector>

#include "config/load/output_file.hpp"

namespace wheelwright::daemon {
namespace {

bool calibrates(const config::DaemonConfig& config) {
  if (config.calibrate == config::CalibrateWhen::never) return false;
  std::error_code ignored;
  return config.calibrate == config::CalibrateWhen::always ||
         !std::filesystem::exists(config.model_file, ignored);
}

}  // namespace

void check_daemon_outputs(const config::DaemonConfig& config, const ProcessOptions& options) {
  std::vector<config::OutputFile> outputs;
  if (!options.status_file.empty() && !options.as_service) {
    outputs.push_back({options.status_file, config::OutputKind::status});
  }
  if (!options.lateness_file.empty())
    outputs.push_back({options.lateness_file, config::OutputKind::lateness});
  if (calibrates(config)) outputs.push_back({config.model_file, config::OutputKind::model});
  if (const auto problem = config::check_outputs(outputs, {options.config_file, options.commands_file})) {
    throw config::ConfigError(*problem);
  }
}

}  // namespace wheelwright::daemon
