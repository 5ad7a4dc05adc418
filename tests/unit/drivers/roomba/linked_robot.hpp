// A RoombaLink on a simulated robot, tick by tick on the virtual clock, with the truth beside what it says.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/roomba/roomba_link.hpp"
#include "drivers/simulation/simulated_robot.hpp"

namespace wheelwright::roomba {

class LinkedRobot {
 public:
  LinkedRobot(const LinkConfig& link_config, const simulation::SimulationConfig& robot_config)
      : link(link_config), robot(robot_config) {
    link.port_opened();
  }

  // Until the robot answers and obeys.
  void start() {
    while (link.state() != LinkState::running && tick_ < 500) tick(std::nullopt);
    link.arm();
    while (!link.armed() && tick_ < 500) tick(std::nullopt);
  }

  SensorFrame drive(double left_m_s, double right_m_s) {
    Command command;
    command.tick = tick_;
    command.speed_m_s = {left_m_s, right_m_s};
    return tick(command);
  }

  SensorFrame drive_for(int ticks, double left_m_s, double right_m_s) {
    for (int i = 1; i < ticks; ++i) drive(left_m_s, right_m_s);
    return drive(left_m_s, right_m_s);
  }

  SensorFrame tick(const std::optional<Command>& command) {
    send(link.begin_tick(tick_, 0.0, command));
    ++tick_;
    std::optional<SensorFrame> frame;
    constexpr auto look = std::chrono::milliseconds(1);
    for (int i = 0; i < 18; ++i) {
      robot.advance(look);
      const auto truth = robot.truth();
      true_ticks.left += 1e-3 * truth.speed_left_m_s / truth.metres_per_tick_left;
      true_ticks.right += 1e-3 * truth.speed_right_m_s / truth.metres_per_tick_right;
      std::array<std::uint8_t, 256> bytes{};
      const std::size_t count = robot.transmit(bytes);
      for (std::size_t at = 0; at < count; ++at) {
        const auto reading = link.receive(bytes.at(at));
        if (reading && !frame) frame = complete(&*reading);
      }
    }
    return frame ? *frame : complete(nullptr);
  }

  RoombaLink link;
  simulation::SimulatedRobot robot;
  WheelPair true_ticks;  // since the start, with the sign of the true motion

 private:
  SensorFrame complete(const open_interface::Reading* reading) {
    const SensorFrame frame = link.complete_tick(reading);
    send(link.urgent_bytes());
    return frame;
  }

  void send(std::span<const std::uint8_t> bytes) {
    if (!bytes.empty()) robot.receive(bytes);
  }

  std::int64_t tick_ = 0;
};

}  // namespace wheelwright::roomba
