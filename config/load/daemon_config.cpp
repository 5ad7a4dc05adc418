#include "config/load/daemon_config.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <system_error>

#include "config/load/commands_file.hpp"
#include "config/load/one_line_text.hpp"
#include "config/load/route_file.hpp"

namespace wheelwright::config {
namespace {

constexpr double fastest_m_s = 0.5;  // what the Open Interface takes

void read_robot(YamlReader& file, DaemonConfig& config) {
  auto robot = file.section("robot");
  if (!robot) return;
  config.robot_name = one_line_text(*robot, "name", config.robot_name);
  config.limits.wheel_base_m = robot->number("wheel_base_m", {0.05, 2.0, "m"}, config.limits.wheel_base_m);
  const double scale =
      robot->number("nominal_metres_per_tick", {1e-6, 0.01, "m"}, config.limits.metres_per_tick.left);
  config.limits.metres_per_tick = {scale, scale};
  config.encoder_turn.options.expected_ticks_per_turn = robot->number(
      "expected_ticks_per_turn", {0.0, 1e6, "ticks"}, config.encoder_turn.options.expected_ticks_per_turn);
  robot->finish();
  config.encoder_turn.options.wheel_base_m = config.limits.wheel_base_m;
}

void read_link(YamlReader& file, DaemonConfig& config) {
  auto link = file.section("link");
  if (!link) return;
  config.device = link->text("device", config.device.string());
  config.baud = static_cast<int>(link->integer("baud", {19200, 115200, "baud"}, config.baud));
  if (config.baud != 115200 && config.baud != 19200) link->fail("baud", "must be 115200 or 19200");
  auto& settings = config.link;
  settings.period_s = link->number("period_s", {0.005, 0.2, "s"}, settings.period_s);
  settings.transport = link->choice<roomba::Transport>(
      "transport", {{"query", roomba::Transport::query}, {"stream", roomba::Transport::stream}},
      settings.transport);
  settings.drive_mode = link->choice<roomba::DriveMode>(
      "drive", {{"direct", roomba::DriveMode::direct}, {"pwm", roomba::DriveMode::pwm}}, settings.drive_mode);
  settings.full_mode = link->choice<bool>("mode", {{"safe", false}, {"full", true}}, settings.full_mode);
  enum class Order : std::uint8_t { automatic, left_is_43, right_is_43 };
  const Order order = link->choice<Order>(
      "encoder_order",
      {{"auto", Order::automatic}, {"left_is_43", Order::left_is_43}, {"right_is_43", Order::right_is_43}},
      Order::automatic);
  config.detect_encoder_order = order == Order::automatic;
  settings.encoder_order =
      order == Order::right_is_43 ? roomba::EncoderOrder::right_is_43 : roomba::EncoderOrder::left_is_43;
  settings.blind_limit_s = link->number("blind_limit_s", {0.02, 5.0, "s"}, settings.blind_limit_s);
  settings.lost_after_s = link->number("lost_after_s", {0.05, 60.0, "s"}, settings.lost_after_s);
  if (settings.lost_after_s < settings.blind_limit_s) {
    link->fail("lost_after_s",
               "must not be shorter than blind_limit_s: the wheels stop before the port is given up");
  }
  link->finish();
}

void read_limits(YamlReader& file, DaemonConfig& config) {
  auto limits = file.section("limits");
  if (!limits) return;
  auto& to = config.limits;
  to.largest_wheel_speed_m_s =
      limits->number("largest_speed_m_s", {0.02, fastest_m_s, "m/s"}, to.largest_wheel_speed_m_s);
  to.slowest_wheel_speed_m_s =
      limits->number("slowest_speed_m_s", {0.0, 0.2, "m/s"}, to.slowest_wheel_speed_m_s);
  to.acceleration_m_s2 = limits->number("acceleration_m_s2", {0.05, 5.0, "m/s^2"}, to.acceleration_m_s2);
  to.ticks_ahead = static_cast<int>(limits->integer("ticks_ahead", {1, 32, "ticks"}, to.ticks_ahead));
  config.link.lowest_battery_v =
      limits->number("lowest_battery_v", {0.0, 30.0, "V"}, config.link.lowest_battery_v);
  limits->finish();
  if (to.slowest_wheel_speed_m_s >= to.largest_wheel_speed_m_s) {
    file.fail("limits", "has a slowest speed that is not below its largest");
  }
}

void read_encoder_turn(YamlReader& calibration, EncoderTurnPlan& plan) {
  auto turn = calibration.section("encoder");
  if (!turn) return;
  plan.speed_m_s = turn->number("speed_m_s", {0.02, fastest_m_s, "m/s"}, plan.speed_m_s);
  plan.turns_each_way = turn->number("turns", {1.6, 20.0, "turns"}, plan.turns_each_way);
  plan.options.method = turn->choice<PeriodMethod>(
      "method", {{"autocorrelation", PeriodMethod::autocorrelation}, {"peak", PeriodMethod::peak}},
      plan.options.method);
  plan.options.largest_standard_error =
      turn->number("largest_relative_error", {1e-5, 0.2}, plan.options.largest_standard_error);
  turn->finish();
}

void read_response(YamlReader& calibration, ResponsePlan& plan) {
  auto response = calibration.section("response");
  if (!response) return;
  plan.speed_m_s = response->number("speed_m_s", {0.02, fastest_m_s, "m/s"}, plan.speed_m_s);
  plan.speed_spread = response->number("speed_spread", {0.0, 1.0}, plan.speed_spread);
  plan.on_s = response->number("on_s", {0.2, 10.0, "s"}, plan.on_s);
  plan.repetitions = static_cast<int>(response->integer("repetitions", {0, 200}, plan.repetitions));
  plan.alternate_direction = response->boolean("alternate_direction", plan.alternate_direction);
  response->finish();
}

void read_order(YamlReader& drive, std::optional<std::size_t>& order) {
  if (!drive.has("order")) return;
  const std::string text = drive.text("order");
  constexpr std::size_t largest_order = 15;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (text != "auto" && (!is_number || number < 1 || number > largest_order)) {
    drive.fail("order", "is '" + text + "', but must be auto or a whole number from 1 to " +
                            std::to_string(largest_order));
  }
  order = is_number ? std::optional(number) : std::nullopt;
}

void read_random_drive(YamlReader& calibration, RandomDrivePlan& plan) {
  auto drive = calibration.section("random_drive");
  if (!drive) return;
  plan.duration_s = drive->number("duration_s", {5.0, 3600.0, "s"}, plan.duration_s);
  plan.spread_m_s = drive->number("spread_m_s", {0.01, fastest_m_s, "m/s"}, plan.spread_m_s);
  plan.shortest_hold_s = drive->number("shortest_hold_s", {0.005, 10.0, "s"}, plan.shortest_hold_s);
  plan.longest_hold_s = drive->number("longest_hold_s", {0.005, 10.0, "s"}, plan.longest_hold_s);
  plan.largest_change_m_s =
      drive->number("largest_change_m_s", {0.01, 2.0 * fastest_m_s, "m/s"}, plan.largest_change_m_s);
  plan.radius_m = drive->number("radius_m", {0.1, 100.0, "m"}, plan.radius_m);
  plan.ahead_m = drive->number("ahead_m", {-100.0, 100.0, "m"}, plan.ahead_m);
  plan.tour_share = drive->number("tour_share", {0.0, 0.95}, plan.tour_share);
  plan.seed =
      static_cast<std::uint64_t>(drive->integer("seed", {0, 1e15}, static_cast<std::int64_t>(plan.seed)));
  read_order(*drive, plan.order);
  if (plan.longest_hold_s < plan.shortest_hold_s) {
    drive->fail("longest_hold_s", "must not be shorter than shortest_hold_s");
  }
  drive->finish();
}

void read_calibration(YamlReader& file, DaemonConfig& config) {
  auto calibration = file.section("calibration");
  if (!calibration) return;
  config.calibrate = calibration->choice<CalibrateWhen>("when",
                                                        {{"always", CalibrateWhen::always},
                                                         {"if_needed", CalibrateWhen::if_needed},
                                                         {"never", CalibrateWhen::never}},
                                                        config.calibrate);
  config.calibration_type = calibration->choice<ModelType>(
      "type", {{"fir", ModelType::fir}, {"arma", ModelType::arma}}, config.calibration_type);
  config.model_file = calibration->text("model_file", config.model_file.string());
  config.adapt = calibration->boolean("adapt", config.adapt);
  read_encoder_turn(*calibration, config.encoder_turn);
  read_response(*calibration, config.response);
  read_random_drive(*calibration, config.random_drive);
  if (config.response.repetitions == 0 && config.calibration_type == ModelType::fir) {
    calibration->fail("response", "has no repetition, which only calibration.type 'arma' can do without");
  }
  calibration->finish();
}

void read_run(YamlReader& file, DaemonConfig& config) {
  auto run = file.section("run");
  if (!run) return;
  if (run->has_section("route")) {
    auto route = run->section("route");
    config.route = read_route(*route);
  } else if (run->has("route")) {
    config.route = load_route(run->existing_file("route"));
  }
  if (run->has_section("commands")) {
    auto commands = run->section("commands");
    config.commanded_drive = read_commands(*commands, config.limits.largest_wheel_speed_m_s);
  } else if (run->has("commands")) {
    config.commanded_drive =
        load_commands(run->existing_file("commands"), config.limits.largest_wheel_speed_m_s);
  }
  if (config.route && config.commanded_drive)
    run->fail("commands", "is given together with a route; keep one of them");
  config.pose_source = run->choice<PoseSource>("pose_source",
                                               {{"fir", PoseSource::fir},
                                                {"arma", PoseSource::arma},
                                                {"hybrid", PoseSource::hybrid},
                                                {"odometry", PoseSource::odometry}},
                                               config.pose_source);
  if (run->has("largest_uncertainty_m")) {
    config.largest_uncertainty_m = run->number("largest_uncertainty_m", {0.001, 100.0, "m"});
  }
  config.arm_at_start =
      run->choice<bool>("arm", {{"at_start", true}, {"by_signal", false}}, config.arm_at_start);
  config.at_end = run->choice<AtEnd>("at_end", {{"exit", AtEnd::exit}, {"stay", AtEnd::stay}}, config.at_end);
  config.log_folder = run->text("log_folder", config.log_folder.string());
  config.mcap_log = run->boolean("mcap", config.mcap_log);
  if (config.route && config.route->speed_m_s > config.limits.largest_wheel_speed_m_s) {
    run->fail("route", "asks for " + std::to_string(config.route->speed_m_s) +
                           " m/s, more than limits.largest_speed_m_s allows");
  }
  run->finish();
}

void read_gap(YamlReader& file, DaemonConfig& config) {
  auto section = file.section("gap");
  if (!section) return;
  config.gap_watch = section->choice<GapWatch>(
      "watch", {{"off", GapWatch::off}, {"when_due", GapWatch::when_due}, {"after_run", GapWatch::after_run}},
      config.gap_watch);
  section->finish();
}

void read_real_time(YamlReader& file, DaemonConfig& config) {
  auto section = file.section("real_time");
  if (!section) return;
  auto& to = config.real_time;
  to.policy = section->choice<RealTimePolicy>("policy",
                                              {{"require", RealTimePolicy::require},
                                               {"prefer", RealTimePolicy::prefer},
                                               {"off", RealTimePolicy::off}},
                                              to.policy);
  to.priority = static_cast<int>(section->integer("priority", {1, 98}, to.priority));
  to.lock_memory = section->boolean("lock_memory", to.lock_memory);
  section->finish();
}

bool is_loopback(const std::string& address) {
  return address == "::1" || address.starts_with("127.");
}

bool is_address(const std::string& text) {
  std::array<unsigned char, sizeof(in6_addr)> ignored{};
  return ::inet_pton(AF_INET, text.c_str(), ignored.data()) == 1 ||
         ::inet_pton(AF_INET6, text.c_str(), ignored.data()) == 1;
}

// A token travels in an address line, and nobody is to guess it.
bool is_token(const std::string& text) {
  constexpr std::size_t shortest = 16;
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  return text.size() >= shortest && std::all_of(text.begin(), text.end(), is_plain);
}

void read_live_view(YamlReader& file, DaemonConfig& config) {
  auto section = file.section("live_view");
  if (!section) return;
  auto& to = config.live_view;
  to.port = static_cast<int>(section->integer("port", {0, 65535}, to.port));
  to.address = section->text("address", to.address);
  to.token = section->text("token", to.token);
  to.truth = section->text("truth", to.truth.string());
  if (!is_address(to.address)) {
    section->fail("address", "is '" + to.address + "', but must be an address, such as 127.0.0.1 or 0.0.0.0");
  }
  if (!to.token.empty() && !is_token(to.token)) {
    section->fail("token",
                  "must be 16 or more letters, digits, - or _, such as 'openssl rand -hex 16' prints");
  }
  if (to.port != 0 && to.token.empty() && !is_loopback(to.address)) {
    section->fail("address",
                  "is '" + to.address + "', where others can call: it needs a token beside it, or 127.0.0.1");
  }
  section->finish();
}

}  // namespace

DaemonConfig load_daemon_config(const std::filesystem::path& path) {
  DaemonConfig config;
  config.file = path;
  YamlReader file = YamlReader::load(path);
  read_robot(file, config);
  read_link(file, config);
  read_limits(file, config);
  read_calibration(file, config);
  read_run(file, config);
  read_gap(file, config);
  read_real_time(file, config);
  read_live_view(file, config);
  file.finish();

  config.limits.period_s = config.link.period_s;
  config.link.largest_speed_m_s = config.limits.largest_wheel_speed_m_s;
  config.limits.command_step_m_s =
      config.link.drive_mode == roomba::DriveMode::direct ? 0.001 : config.link.pwm_full_scale_m_s / 255.0;
  config.response.use_fall = config.link.drive_mode == roomba::DriveMode::direct;
  for (const double speed : {config.encoder_turn.speed_m_s, config.response.speed_m_s}) {
    if (speed > config.limits.largest_wheel_speed_m_s) {
      throw ConfigError(path.string() + ": a calibration speed of " + std::to_string(speed) +
                        " m/s is more than limits.largest_speed_m_s allows");
    }
  }
  return config;
}

}  // namespace wheelwright::config
