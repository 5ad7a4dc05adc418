#include "tests/loopback/bench/bench.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "tests/support/catch.hpp"

namespace wheelwright::bench {
namespace {

constexpr auto model =
    "wheelwright_model: 1\n"
    "wheel_base_m: 0.235\n"
    "period_s: 0.018\n"
    "encoder_scale:\n"
    "  metres_per_tick_left: 0.000444565\n"
    "  metres_per_tick_right: 0.000444565\n"
    "  ticks_per_turn: 1660\n"
    "  relative_standard_error: 0.002\n"
    "core:\n"
    "  type: fir\n"
    "  left:\n"
    "    from_left: [0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1]\n"
    "    from_right: [0, 0, 0, 0, 0, 0, 0]\n"
    "  right:\n"
    "    from_left: [0, 0, 0, 0, 0, 0, 0]\n"
    "    from_right: [0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1]\n";

std::string section(const std::string& name, const std::string& keys) {
  return keys.empty() ? "" : name + ": {" + keys + "}\n";
}

}  // namespace

std::filesystem::path Bench::write(const std::string& name, const std::string& text) const {
  const auto path = folder() / name;
  std::ofstream(path) << text;
  return path;
}

std::unique_ptr<ChildProcess> Bench::start_robot(const std::string& shipped, const std::string& changes,
                                                 const std::vector<std::string>& options) {
  const std::string base = std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/robots/" + shipped + ".yaml";
  const auto config = write("robot.yaml", "based_on: " + base + "\n" + changes);
  std::vector<std::string> command{ROOMBA_SIM, "--config", config.string(),      "--link",
                                   device(),   "--truth",  truth_file().string()};
  command.insert(command.end(), options.begin(), options.end());
  auto robot = std::make_unique<ChildProcess>(command, folder() / "robot_said", Scheduling::like_hardware);
  const bool there = eventually(5s, [this] { return std::filesystem::is_symlink(device()); });
  if (!there) throw std::runtime_error("roomba-sim did not start: " + robot->err());
  return robot;
}

std::filesystem::path Bench::configure(const DaemonSetup& setup) const {
  if (setup.has_model) write("model.yaml", model);
  std::string run = "log_folder: " + (folder() / "runs").string();
  if (!setup.route.empty()) {
    write("route.yaml", "name: test\nspeed: " + std::to_string(setup.speed_m_s) +
                            "\ntolerance: 0.02\ncheckpoints: " + setup.route + "\n");
    run += ", route: route.yaml";
  }
  if (!setup.run.empty()) run += ", " + setup.run;
  const std::string link =
      "device: " + (folder() / setup.device).string() + (setup.link.empty() ? "" : ", " + setup.link);
  const std::string calibration = setup.calibration + ", model_file: " + (folder() / "model.yaml").string();
  return write("daemon.yaml", section("link", link) + section("limits", setup.limits) +
                                  section("calibration", calibration) + section("run", run) +
                                  "real_time: {policy: prefer, lock_memory: false}\n" +
                                  section("live_view", setup.live_view));
}

std::unique_ptr<ChildProcess> Bench::start_daemon(const std::filesystem::path& config,
                                                  const std::vector<std::string>& wrapper,
                                                  const std::vector<std::string>& options) const {
  std::vector<std::string> command = wrapper;
  command.insert(command.end(), {WHEELWRIGHTD, "--config", config.string()});
  command.insert(command.end(), options.begin(), options.end());
  return std::make_unique<ChildProcess>(command, folder() / "daemon_said");
}

std::vector<std::filesystem::path> Bench::runs() const {
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder() / "runs", ignored)) {
    found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  if (found.empty()) throw std::runtime_error("the daemon has made no folder for its logs");
  return found;
}

Replies replies_of(const std::string& summary) {
  Replies replies;
  const std::size_t at = summary.find("  replies ");
  if (at == std::string::npos ||
      std::sscanf(summary.c_str() + at, " replies %d of %d sound, %d missing, %d incomplete, %d garbled",
                  &replies.sound, &replies.asked, &replies.missing, &replies.incomplete,
                  &replies.garbled) != 5) {
    throw std::runtime_error("no counts of replies in the summary:\n" + summary);
  }
  return replies;
}

int skipped_periods_of(const std::string& summary) {
  const std::size_t at = summary.find("  periods skipped ");
  int skipped = 0;
  if (at == std::string::npos || std::sscanf(summary.c_str() + at, " periods skipped %d", &skipped) != 1) {
    throw std::runtime_error("no count of skipped periods in the summary:\n" + summary);
  }
  return skipped;
}

Travel travel_of(const Table& truth) {
  const double period_s = std::stod(truth.metadata("period_s"));
  Travel travel;
  for (std::size_t row = 0; row < truth.rows(); ++row) {
    travel.left_m += period_s * truth.number(row, "speed_left");
    travel.right_m += period_s * truth.number(row, "speed_right");
  }
  return travel;
}

void skip(const std::string& why) {
  WARN("SKIPPED: " << why);
  SUCCEED("SKIPPED");
}

}  // namespace wheelwright::bench
