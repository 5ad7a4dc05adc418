#include "tools/wheelwright/evaluation/random_drive.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "drivers/roomba/roomba_link.hpp"
#include "drivers/simulation/noise.hpp"

namespace wheelwright::tools {
namespace {

constexpr double command_spread_m_s = 0.1;
constexpr double largest_change_m_s = 0.15;  // a harder step makes the robot report an overcurrent
// Long enough for a wheel to settle: the gain, which decides where a route ends, shows in what it settles at.
constexpr int hold_ticks = 50;
constexpr int ticks_to_start = 100;

class TickedRobot {
 public:
  TickedRobot(simulation::SimulatedRobot& robot, const roomba::LinkConfig& link, double period_s)
      : robot_(robot), link_(link), period_s_(period_s) {
    link_.port_opened();
  }

  SensorFrame tick(const WheelPair& speed_m_s) {
    Command command;
    command.tick = tick_;
    command.speed_m_s = speed_m_s;
    if (link_.state() == roomba::LinkState::running && !asked_to_arm_) {
      link_.arm();
      asked_to_arm_ = true;
    }
    send(link_.begin_tick(tick_, static_cast<double>(tick_) * period_s_, command));
    ++tick_;
    robot_.advance(std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * period_s_)));
    std::array<std::uint8_t, 512> bytes{};
    const std::size_t count = robot_.transmit(bytes);
    std::optional<open_interface::Reading> heard;
    for (std::size_t i = 0; i < count; ++i) {
      const auto reading = link_.receive(bytes.at(i));
      if (reading && !heard) heard = *reading;
    }
    const SensorFrame frame = link_.complete_tick(heard ? &*heard : nullptr);
    send(link_.urgent_bytes());
    return frame;
  }

 private:
  void send(std::span<const std::uint8_t> bytes) {
    if (!bytes.empty()) robot_.receive(bytes);
  }

  simulation::SimulatedRobot& robot_;
  roomba::RoombaLink link_;
  double period_s_;
  std::int64_t tick_ = 0;
  bool asked_to_arm_ = false;
};

}  // namespace

DriveLog drive_randomly(simulation::SimulatedRobot& robot, const roomba::LinkConfig& link,
                        const RobotLimits& limits, const WheelPair& metres_per_tick, double duration_s,
                        std::uint64_t seed) {
  TickedRobot ticked(robot, link, limits.period_s);
  for (int i = 0; i < ticks_to_start; ++i) ticked.tick({});
  DriveLog log;
  log.name = "random drive";
  log.wheel_base_m = limits.wheel_base_m;
  log.period_s = limits.period_s;
  log.metres_per_tick = metres_per_tick;
  simulation::Noise chance(seed);
  const auto draw = [&](double before) {
    const double wanted = command_spread_m_s * chance.normal();
    const double speed = std::clamp(wanted, before - largest_change_m_s, before + largest_change_m_s);
    return limits.command_step_m_s * std::round(speed / limits.command_step_m_s);
  };
  WheelPair command;
  const int ticks = static_cast<int>(duration_s / limits.period_s);
  for (int k = 0; k < ticks; ++k) {
    if (k % hold_ticks == 0) command = {draw(command.left), draw(command.right)};
    const SensorFrame frame = ticked.tick(command);
    if (frame.stop != StopReason::none) break;
    if (!frame.valid) continue;
    DriveSample sample;
    sample.t_s = static_cast<double>(k) * limits.period_s;
    sample.command_m_s = frame.command.speed_m_s;
    sample.ticks = frame.ticks;
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace wheelwright::tools
