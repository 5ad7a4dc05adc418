#include "config/load/daemon_config.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

class Yaml {
 public:
  void section(const std::string& name) { text_ += name + ":\n"; }
  void subsection(const std::string& name) { text_ += "  " + name + ":\n"; }

  void word(const std::string& key, const std::string& value) { text_ += "  " + key + ": " + value + "\n"; }
  void text(const std::string& key, const std::string& value) { word(key, quoted(value)); }
  void number(const std::string& key, double value) { word(key, plain_number(value)); }
  void flag(const std::string& key, bool value) { word(key, value ? "true" : "false"); }

  const std::string& all() const { return text_; }

 private:
  std::string text_;
};

std::string name_of(CalibrateWhen when) {
  if (when == CalibrateWhen::always) return "always";
  return when == CalibrateWhen::never ? "never" : "if_needed";
}

std::string name_of(GapWatch watch) {
  if (watch == GapWatch::off) return "off";
  return watch == GapWatch::when_due ? "when_due" : "after_run";
}

std::string name_of(RealTimePolicy policy) {
  if (policy == RealTimePolicy::require) return "require";
  return policy == RealTimePolicy::off ? "off" : "prefer";
}

std::string order_of(const DaemonConfig& config) {
  if (config.detect_encoder_order) return "auto";
  return config.link.encoder_order == roomba::EncoderOrder::left_is_43 ? "left_is_43" : "right_is_43";
}

void add_robot_and_link(Yaml& yaml, const DaemonConfig& config) {
  yaml.section("robot");
  yaml.text("name", config.robot_name);
  yaml.number("wheel_base_m", config.limits.wheel_base_m);
  yaml.number("nominal_metres_per_tick", config.limits.metres_per_tick.left);
  yaml.number("expected_ticks_per_turn", config.encoder_turn.options.expected_ticks_per_turn);
  yaml.section("link");
  yaml.text("device", config.device.string());
  yaml.number("baud", config.baud);
  yaml.number("period_s", config.link.period_s);
  yaml.word("transport", config.link.transport == roomba::Transport::query ? "query" : "stream");
  yaml.word("drive", config.link.drive_mode == roomba::DriveMode::direct ? "direct" : "pwm");
  yaml.word("mode", config.link.full_mode ? "full" : "safe");
  yaml.word("encoder_order", order_of(config));
  yaml.number("blind_limit_s", config.link.blind_limit_s);
  yaml.number("lost_after_s", config.link.lost_after_s);
  yaml.section("limits");
  yaml.number("largest_speed_m_s", config.limits.largest_wheel_speed_m_s);
  yaml.number("slowest_speed_m_s", config.limits.slowest_wheel_speed_m_s);
  yaml.number("acceleration_m_s2", config.limits.acceleration_m_s2);
  yaml.number("lowest_battery_v", config.link.lowest_battery_v);
  yaml.number("ticks_ahead", config.limits.ticks_ahead);
}

void add_calibration(Yaml& yaml, const DaemonConfig& config) {
  yaml.section("calibration");
  yaml.word("when", name_of(config.calibrate));
  yaml.word("type", config.calibration_type == ModelType::arma ? "arma" : "fir");
  yaml.text("model_file", config.model_file.string());
  yaml.flag("adapt", config.adapt);
  const EncoderTurnPlan& turn = config.encoder_turn;
  yaml.subsection("encoder");
  yaml.number("  speed_m_s", turn.speed_m_s);
  yaml.number("  turns", turn.turns_each_way);
  yaml.word("  method", turn.options.method == PeriodMethod::autocorrelation ? "autocorrelation" : "peak");
  yaml.number("  largest_relative_error", turn.options.largest_standard_error);
  const ResponsePlan& response = config.response;
  yaml.subsection("response");
  yaml.number("  speed_m_s", response.speed_m_s);
  yaml.number("  speed_spread", response.speed_spread);
  yaml.number("  on_s", response.on_s);
  yaml.number("  repetitions", response.repetitions);
  yaml.flag("  alternate_direction", response.alternate_direction);
  const RandomDrivePlan& drive = config.random_drive;
  yaml.subsection("random_drive");
  yaml.number("  duration_s", drive.duration_s);
  yaml.number("  spread_m_s", drive.spread_m_s);
  yaml.number("  shortest_hold_s", drive.shortest_hold_s);
  yaml.number("  longest_hold_s", drive.longest_hold_s);
  yaml.number("  largest_change_m_s", drive.largest_change_m_s);
  yaml.number("  radius_m", drive.radius_m);
  yaml.number("  ahead_m", drive.ahead_m);
  yaml.number("  tour_share", drive.tour_share);
  yaml.word("  seed", std::to_string(drive.seed));
  yaml.word("  order", drive.order ? std::to_string(*drive.order) : "auto");
}

void add_run(Yaml& yaml, const DaemonConfig& config) {
  yaml.section("run");
  if (config.route) {
    yaml.subsection("route");
    yaml.text("  name", config.route->name);
    yaml.number("  speed", config.route->speed_m_s);
    yaml.number("  tolerance", config.route->tolerance_m);
    std::string points;
    for (const Checkpoint& point : config.route->checkpoints) {
      points +=
          (points.empty() ? "[" : ", [") + plain_number(point.x_m) + ", " + plain_number(point.y_m) + "]";
    }
    yaml.word("  checkpoints", "[" + points + "]");
  }
  if (config.commanded_drive) {
    yaml.subsection("commands");
    yaml.text("  name", config.commanded_drive->name);
    yaml.number("  duration_s", config.commanded_drive->duration_s);
    const auto list = [&](const std::string& key, const auto& number_of) {
      std::string numbers;
      for (const auto& row : config.commanded_drive->rows) {
        numbers += (numbers.empty() ? "" : ", ") + plain_number(number_of(row));
      }
      yaml.word("  " + key, "[" + numbers + "]");
    };
    using Row = CommandedDrive::Row;
    list("t_s", [](const Row& row) { return row.t_s; });
    list("left_m_s", [](const Row& row) { return row.command_m_s.left; });
    list("right_m_s", [](const Row& row) { return row.command_m_s.right; });
  }
  yaml.word("pose_source", std::string(wheelwright::name_of(config.pose_source)));
  if (config.largest_uncertainty_m) yaml.number("largest_uncertainty_m", *config.largest_uncertainty_m);
  yaml.word("arm", config.arm_at_start ? "at_start" : "by_signal");
  yaml.word("at_end", config.at_end == AtEnd::exit ? "exit" : "stay");
  yaml.text("log_folder", config.log_folder.string());
  yaml.flag("mcap", config.mcap_log);
  yaml.section("gap");
  yaml.word("watch", name_of(config.gap_watch));
  yaml.section("real_time");
  yaml.word("policy", name_of(config.real_time.policy));
  yaml.number("priority", config.real_time.priority);
  yaml.flag("lock_memory", config.real_time.lock_memory);
}

}  // namespace

std::string daemon_config_to_yaml(const DaemonConfig& config) {
  Yaml yaml;
  add_robot_and_link(yaml, config);
  add_calibration(yaml, config);
  add_run(yaml, config);
  return yaml.all();
}

}  // namespace wheelwright::config
