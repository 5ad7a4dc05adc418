// serial-faults: a faulty cable between a robot (or roomba-sim) and whatever drives it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "config/load/output_file.hpp"
#include "config/load/printable_text.hpp"
#include "drivers/serial/serial_port.hpp"
#include "drivers/simulation/faulty_bridge.hpp"
#include "tools/option_checks.hpp"

namespace {

namespace config = wheelwright::config;
namespace simulation = wheelwright::simulation;

using wheelwright::tools::number_between;

constexpr double day_s = 86400.0;
constexpr int done = 0;
constexpr int robot_gone = 1;
constexpr int bad_usage = 2;

struct Options {
  std::string robot;
  std::string link;
  std::string log;
  std::vector<std::string> kinds;
  int baud = 115200;
  std::int64_t faults = 0;
  std::optional<double> shortest_pause_s;
  std::optional<double> longest_pause_s;
  simulation::CableFaultConfig cable;
};

std::string known_kinds() {
  std::string text;
  for (int kind = 0; kind < simulation::cable_fault_kinds; ++kind) {
    text += (kind == 0 ? "" : ", ") + std::string(name_of(static_cast<simulation::CableFaultKind>(kind)));
  }
  return text;
}

void describe(CLI::App& app, Options& options) {
  app.add_option("--robot", options.robot, "the serial port of the robot, or the --link of roomba-sim")
      ->required();
  app.add_option("--link", options.link, "make a symbolic link here to the port for the host")->required();
  app.add_option("--seed", options.cable.seed, "of the faults (1)")->check(CLI::NonNegativeNumber);
  app.add_option("--kinds", options.kinds, "only these, comma separated: " + known_kinds())->delimiter(',');
  app.add_option("--first", options.cable.first_after_s, "time until the first fault (2)")
      ->check(number_between(0.0, day_s, "s"));
  app.add_option("--shortest-pause", options.shortest_pause_s,
                 "time between faults, at least (2, or --longest-pause where that is less)")
      ->check(number_between(0.001, day_s, "s"));
  app.add_option("--longest-pause", options.longest_pause_s,
                 "and at most (4, or --shortest-pause where that is more)")
      ->check(number_between(0.001, day_s, "s"));
  app.add_option("--faults", options.faults, "so many, then only carry on (no end)")
      ->check(CLI::PositiveNumber);
  app.add_option("--log", options.log, "write each fault to this CSV file");
  app.add_option("--baud", options.baud, "of the robot's port (115200)");
  app.set_version_flag("--version", "serial-faults " WHEELWRIGHT_VERSION);
  app.footer(
      "Runs until SIGTERM or SIGINT, then prints what it did. While the cable is out the link is gone.\n"
      "\n"
      "Example:\n"
      "  roomba-sim --link /tmp/roomba &\n"
      "  serial-faults --robot /tmp/roomba --link /tmp/bad_roomba --seed 7 --log faults.csv &\n"
      "  wheelwrightd --config config/wheelwright.yaml --device /tmp/bad_roomba");
}

void settle(Options& options) {
  for (const std::string& name : options.kinds) {
    const auto kind = simulation::cable_fault_kind(name);
    if (!kind)
      throw std::runtime_error("--kinds: no fault is called '" + name + "'; there are " + known_kinds());
    options.cable.kinds.push_back(*kind);
  }
  auto& cable = options.cable;
  if (options.shortest_pause_s && options.longest_pause_s &&
      *options.shortest_pause_s > *options.longest_pause_s) {
    throw std::runtime_error("--shortest-pause is longer than --longest-pause; exchange them");
  }
  const double longest_s = options.longest_pause_s.value_or(cable.longest_pause_s);
  cable.shortest_pause_s = options.shortest_pause_s.value_or(std::min(cable.shortest_pause_s, longest_s));
  cable.longest_pause_s = std::max(longest_s, cable.shortest_pause_s);
}

class FaultLog {
 public:
  explicit FaultLog(const std::string& path) {
    if (path.empty()) return;
    const auto file = config::open_output({path, config::OutputKind::cable_faults});
    if (!file) throw std::runtime_error(file.error());
    descriptor_ = *file;
    out_ << "# wheelwright_cable_faults: 1\n"
            "kind,to_robot,to_host,from_unix_s,until_unix_s,amount,bytes_passed,bytes_hit,bytes_added,"
            "answered_after_s\n";
    out_.setf(std::ios::fixed);
    out_.precision(4);
    write_on();
  }
  FaultLog(const FaultLog&) = delete;
  FaultLog& operator=(const FaultLog&) = delete;
  ~FaultLog() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void add(const simulation::BridgeFault& bridged) {
    const auto& fault = bridged.record.fault;
    ++counts_.at(static_cast<std::size_t>(fault.kind));
    ++count_;
    bytes_hit_ += bridged.record.bytes_hit;
    if (descriptor_ < 0) return;
    out_ << name_of(fault.kind) << ',' << fault.to_robot << ',' << fault.to_host << ',' << bridged.from_unix_s
         << ',' << bridged.until_unix_s << ',' << fault.amount << ',' << bridged.record.bytes_passed << ','
         << bridged.record.bytes_hit << ',' << bridged.record.bytes_added << ',';
    if (bridged.answered_after_s) out_ << *bridged.answered_after_s;
    out_ << '\n';
    write_on();
  }

  std::int64_t count() const { return count_; }

  void print() const {
    std::printf("%lld faults, %lld bytes hit:", static_cast<long long>(count_),
                static_cast<long long>(bytes_hit_));
    for (std::size_t kind = 0; kind < counts_.size(); ++kind) {
      const auto name = name_of(static_cast<simulation::CableFaultKind>(kind));
      std::printf(" %lld %.*s%s", static_cast<long long>(counts_.at(kind)), static_cast<int>(name.size()),
                  name.data(), kind + 1 < counts_.size() ? "," : "\n");
    }
  }

 private:
  // Whoever watches sees it now.
  void write_on() {
    config::write_all(descriptor_, out_.str());
    out_.str({});
  }

  int descriptor_ = -1;
  std::ostringstream out_;
  std::array<std::int64_t, simulation::cable_fault_kinds> counts_{};
  std::int64_t count_ = 0;
  std::int64_t bytes_hit_ = 0;
};

int run(Options options) {
  settle(options);
  sigset_t ends{};
  ::sigemptyset(&ends);
  ::sigaddset(&ends, SIGTERM);
  ::sigaddset(&ends, SIGINT);
  ::sigprocmask(SIG_BLOCK, &ends, nullptr);
  const auto port = wheelwright::serial::open_port(options.robot, options.baud);
  if (!port) throw std::runtime_error(detailed_message(port.error(), options.robot));
  FaultLog log(options.log);
  simulation::FaultyBridge bridge(port->descriptor, options.link, options.cable);
  constexpr timespec beat{0, 1'000'000};
  int status = done;
  while (::sigtimedwait(&ends, nullptr, &beat) < 0) {
    if (!bridge.carry()) {
      std::cerr << "serial-faults: " << wheelwright::config::printable(options.robot) << ": is gone\n";
      status = robot_gone;
      break;
    }
    while (const auto fault = bridge.next_finished()) log.add(*fault);
    if (options.faults > 0 && log.count() >= options.faults) bridge.let_be();
  }
  ::close(port->descriptor);
  log.print();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A faulty cable between a robot and whatever drives it: what goes wrong is drawn from a seed.",
               "serial-faults");
  describe(app, options);
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    const std::string what = error.what();
    std::cerr << "serial-faults: " << wheelwright::config::printable(what.substr(0, what.find('\n')))
              << "; try --help\n";
  } catch (const std::exception& error) {
    std::cerr << "serial-faults: " << wheelwright::config::printable(error.what()) << '\n';
  }
  return bad_usage;
}
