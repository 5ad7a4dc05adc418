// wheelwright status: how a running daemon is, by the file that it writes every second.
#include <signal.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <ostream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/common/json_text.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto fresh_for = std::chrono::seconds(5);

struct StatusOptions {
  std::string file = "/run/wheelwright/status.json";
  bool as_json = false;
};

json read_status(const std::string& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw DataRefusal(file + ": not there; no daemon runs, or it was started without --status FILE");
  }
  try {
    json status = load_json(file);
    if (status.at("wheelwright_status") != 1) throw UsageError(file + ": of a version that is not known");
    return status;
  } catch (const json::exception&) {
    throw UsageError(file + ": not what wheelwrightd --status writes");
  }
}

// A process that may not be asked is there all the same.
bool is_there(int pid) {
  return ::kill(pid, 0) == 0 || errno == EPERM;
}

// The form of the daemon's own table at the end of a run.
class Table {
 public:
  explicit Table(std::ostream& out) : out_(out) { out_ << std::fixed; }

  std::ostream& row(const std::string& name) {
    return out_ << "  " << std::left << std::setw(28) << name << std::right;
  }

 private:
  std::ostream& out_;
};

void print_loop(Table& table, const json& loop) {
  table.row("system") << config::printable(loop.at("system").get<std::string>()) << "\n";
  table.row("ticks") << loop.at("ticks") << " of " << std::setprecision(1)
                     << 1e3 * loop.at("period_s").get<double>() << " ms\n";
  table.row("overruns") << loop.at("overruns") << ", " << loop.at("skipped_periods") << " periods skipped\n";
  table.row("commands late") << loop.at("commands_late") << "\n";
  const json& lateness = loop.at("lateness_us");
  table.row("wake-up lateness") << std::setprecision(0) << "p50 " << lateness.at("p50").get<double>()
                                << " us, p99 " << lateness.at("p99").get<double>() << " us, largest "
                                << lateness.at("largest").get<double>() << " us\n";
  for (const json& step : lateness.at("histogram")) {
    std::ostringstream edge;
    edge << std::fixed << std::setprecision(1) << "  up to " << step.at(0).get<double>() << " us";
    table.row(edge.str()) << step.at(1) << "\n";
  }
}

void print(std::ostream& out, const json& status) {
  Table table(out);
  const auto text = [&](const char* key) { return status.at(key).get<std::string>(); };
  out << config::printable(text("robot")) << " on " << config::printable(text("device")) << ": "
      << config::printable(text("phase")) << "\n";
  if (status.contains("pose")) {
    const json& pose = status["pose"];
    constexpr double degrees = 180.0 / M_PI;
    table.row("pose") << std::setprecision(3) << pose.at("x_m").get<double>() << " m, "
                      << pose.at("y_m").get<double>() << " m, " << std::setprecision(1)
                      << degrees * pose.at("theta_rad").get<double>() << " deg by "
                      << config::printable(pose.at("by").get<std::string>()) << "\n";
  }
  if (status.contains("battery_v") && !status["battery_v"].is_null()) {
    table.row("battery") << std::setprecision(1) << status["battery_v"].get<double>() << " V\n";
  }
  if (status.contains("watch") && !status["watch"].is_null())
    table.row("watch over the model") << config::printable(status["watch"].get<std::string>()) << "\n";
  print_loop(table, status.at("loop"));
  table.row("logs") << config::printable(text("run_folder")) << "\n";
}

ExitStatus run_status(const StatusOptions& options, Streams streams) {
  const json status = read_status(options.file);
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(options.file);
  if (!is_there(status.value("pid", 0)) || age > fresh_for) {
    throw DataRefusal(options.file + ": the daemon that wrote it at " + status.value("time", "?") +
                      " does not run any more, or hangs");
  }
  if (options.as_json) {
    streams.out << json_text(status) << "\n";
  } else {
    try {
      print(streams.out, status);
    } catch (const json::exception&) {
      throw UsageError(options.file + ": not what wheelwrightd --status writes");
    }
  }
  return ExitStatus::done;
}

}  // namespace

Action add_status(CLI::App& app) {
  const auto options = std::make_shared<StatusOptions>();
  CLI::App* command = app.add_subcommand("status", "How a running daemon is, and how late its loop was");
  command->add_option("FILE", options->file, "What wheelwrightd --status writes (default: of the service)");
  command->add_flag("--json", options->as_json, "As JSON");
  command->footer("Exit status 1: no daemon runs, or it hangs.\nExample: wheelwright status --json");
  return [options](Streams streams) { return run_status(*options, streams); };
}

}  // namespace wheelwright::tools
