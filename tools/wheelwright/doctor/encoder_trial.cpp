#include "tools/wheelwright/doctor/encoder_trial.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"
#include "drivers/roomba/roomba_link.hpp"

namespace wheelwright::tools::doctor {
namespace {

constexpr double speed_m_s = 0.05;
constexpr double leg_s = 0.5;
constexpr double rest_s = 0.3;  // the wheel coasts to its end before it is sent back
constexpr double shortest_tick_s = 0.04;
constexpr double arming_patience_s = 1.5;
constexpr double min_share_of_expected = 0.3;  // dead zones and carpets take their part
constexpr double clear_ratio = 3.0;

// The daemon's own link, and with it the daemon's own safety, at the pace of this test.
class Trial {
 public:
  Trial(RobotLine& line, const roomba::LinkConfig& config)
      : line_(line), link_(config), period_(std::chrono::duration<double>(config.period_s)) {
    link_.port_opened();
  }

  EncoderTrial run() {
    EncoderTrial trial;
    if (!arm()) {
      trial.stop = link_.stop_reason();
      return trial;
    }
    trial.armed = true;
    for (const double direction : {1.0, -1.0}) {
      const WheelPair before = ticks_;
      run_for(leg_s, direction * speed_m_s);
      run_for(rest_s, 0.0);
      trial.ticks_43 += std::abs(ticks_.left - before.left);
      trial.ticks_44 += std::abs(ticks_.right - before.right);
    }
    trial.stop = link_.stop_reason();
    return trial;
  }

 private:
  bool arm() {
    run_for(8.0 * link_.config().period_s, 0.0);
    link_.arm();
    for (double waited_s = 0.0; waited_s < arming_patience_s; waited_s += link_.config().period_s) {
      if (link_.armed()) return true;
      if (link_.stop_reason() != StopReason::none) return false;
      tick(0.0);
    }
    return link_.armed();
  }

  void run_for(double duration_s, double left_m_s) {
    const auto ticks = std::llround(duration_s / link_.config().period_s);
    for (std::int64_t i = 0; i < ticks; ++i) tick(left_m_s);
  }

  void tick(double left_m_s) {
    Command command;
    command.tick = ++tick_;
    command.speed_m_s = {left_m_s, 0.0};
    line_.send(link_.begin_tick(tick_, 0.0, command));
    const auto end = Clock::now() + std::chrono::round<Clock::duration>(period_);
    std::optional<open_interface::Reading> reading;
    while (Clock::now() < end) {
      for (const std::uint8_t byte : line_.receive(end)) {
        if (const auto found = link_.receive(byte); found && !reading) {
          reading = found;
          take(link_.complete_tick(&*reading));
        }
      }
    }
    if (!reading) take(link_.complete_tick(nullptr));
  }

  void take(const SensorFrame& frame) {
    const auto urgent = link_.urgent_bytes();
    if (!urgent.empty()) line_.send(urgent);
    if (frame.valid) ticks_ = {static_cast<double>(frame.ticks.left), static_cast<double>(frame.ticks.right)};
  }

  RobotLine& line_;
  roomba::RoombaLink link_;
  std::chrono::duration<double> period_;
  std::int64_t tick_ = -1;
  WheelPair ticks_;
};

// Whatever ends the trial, an exception too, ends the motion.
class RestAtEnd {
 public:
  explicit RestAtEnd(RobotLine& line) : line_(line) {}
  RestAtEnd(const RestAtEnd&) = delete;
  RestAtEnd& operator=(const RestAtEnd&) = delete;
  ~RestAtEnd() { line_.leave_at_rest(); }

 private:
  RobotLine& line_;
};

Finding stopped(const std::string& how, const std::string& remedy) {
  return {"encoder order", how, State::failed, remedy};
}

std::string remedy_for(StopReason reason) {
  switch (reason) {
    case StopReason::bump:
      return "free the bumper and put the robot where it has 10 cm around it";
    case StopReason::cliff:
    case StopReason::wheel_drop:
      return "put the robot with both wheels on the floor, away from edges";
    case StopReason::charging:
      return "take the robot off its charger";
    case StopReason::low_battery:
      return "charge the battery";
    case StopReason::overcurrent:
      return "look for what blocks the wheel: hair, carpet, a wall";
    case StopReason::mode_changed:
      return "the robot refuses or leaves Safe mode: wheels on the floor, no edge near, charger off?";
    default:
      return "the sensors were silent while the wheel turned: see replies and query round trip";
  }
}

}  // namespace

EncoderTrial try_left_wheel(RobotLine& line, const config::DaemonConfig& config, double slowest_reply_s) {
  roomba::LinkConfig link = config.link;
  link.period_s = std::max(shortest_tick_s, 2.0 * slowest_reply_s);
  link.transport = roomba::Transport::query;
  link.drive_mode = roomba::DriveMode::direct;
  link.full_mode = false;
  link.encoder_order = roomba::EncoderOrder::left_is_43;  // so that left means 43 below
  const RestAtEnd rest(line);
  EncoderTrial trial = Trial(line, link).run();
  trial.expected_ticks = 2.0 * leg_s * speed_m_s / config.limits.metres_per_tick.left;
  return trial;
}

Finding judge_encoders(const EncoderTrial& trial, const config::DaemonConfig& config) {
  if (trial.stop != StopReason::none) {
    return stopped("stopped: " + std::string(name_of(trial.stop)), remedy_for(trial.stop));
  }
  if (!trial.armed) return stopped("the robot did not take Safe mode", remedy_for(StopReason::mode_changed));
  const double larger = std::max(trial.ticks_43, trial.ticks_44);
  const double smaller = std::min(trial.ticks_43, trial.ticks_44);
  const std::string ticks = config::fixed_number(trial.ticks_43, 0) + " ticks of 43, " +
                            config::fixed_number(trial.ticks_44, 0) + " of 44";
  const std::vector<std::pair<std::string, double>> values{
      {"ticks_43", trial.ticks_43}, {"ticks_44", trial.ticks_44}, {"expected_ticks", trial.expected_ticks}};
  if (larger < min_share_of_expected * trial.expected_ticks) {
    auto finding = stopped("hardly moved: " + ticks,
                           "about " + config::fixed_number(trial.expected_ticks, 0) +
                               " were expected: is the left wheel blocked or its motor cut off?");
    finding.values = values;
    return finding;
  }
  if (larger < clear_ratio * smaller) {
    auto finding =
        stopped("not clear: " + ticks, "both wheels moved: put the robot on level floor and repeat");
    finding.values = values;
    return finding;
  }
  const bool left_is_43 = trial.ticks_43 > trial.ticks_44;
  Finding finding{
      "encoder order",
      std::string(left_is_43 ? "43 is left, 44 right" : "43 is right, 44 left") + " (" + ticks + ")",
      State::ok, "", values};
  const bool configured_left = config.link.encoder_order == roomba::EncoderOrder::left_is_43;
  if (!config.detect_encoder_order && configured_left != left_is_43) {
    finding.state = State::failed;
    finding.remedy =
        std::string("set link.encoder_order: ") + (left_is_43 ? "left_is_43" : "right_is_43") + ", or auto";
  }
  return finding;
}

}  // namespace wheelwright::tools::doctor
