// A host for a simulated robot in a test: sends commands, moves time, reads answers.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "config/load/simulation_config.hpp"
#include "drivers/simulation/simulated_robot.hpp"

namespace wheelwright::simulation {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

inline SimulationConfig shipped_robot(const std::string& name) {
  return config::load_simulation_config(std::filesystem::path(WHEELWRIGHT_SOURCE_DIR) / "config/robots" /
                                        name);
}

inline RoomConfig shipped_room(const std::string& name) {
  return config::load_room(std::filesystem::path(WHEELWRIGHT_SOURCE_DIR) / "config/robots/rooms" / name);
}

class Host {
 public:
  explicit Host(const SimulationConfig& config) : robot(config) {}
  explicit Host(SimulatedRobot&& given) : robot(std::move(given)) {}

  void send(const Bytes& bytes) { robot.receive(bytes); }

  Bytes read() {
    Bytes all;
    std::array<std::uint8_t, 1024> part{};
    while (const std::size_t count = robot.transmit(part))
      all.insert(all.end(), part.begin(), part.begin() + count);
    return all;
  }

  // Sends, waits long enough for an answer, and takes it.
  Bytes ask(const Bytes& bytes, std::chrono::nanoseconds wait = 20ms) {
    send(bytes);
    robot.advance(wait);
    return read();
  }

  std::int32_t packet(std::uint8_t id, std::chrono::nanoseconds wait = 20ms) {
    const Bytes answer = ask({142, id}, wait);
    if (answer.size() == 1) return answer[0];
    if (answer.size() != 2) return -99999;
    return static_cast<std::int16_t>((answer[0] << 8U) | answer[1]);
  }

  void start(std::uint8_t mode = 131) { ask({128, mode}); }

  void drive(int left_mm_s, int right_mm_s) { send(wheel_command(145, left_mm_s, right_mm_s)); }
  void drive_pwm(int left, int right) { send(wheel_command(146, left, right)); }

  SimulatedRobot robot;

 private:
  static Bytes wheel_command(std::uint8_t opcode, int left, int right) {
    const auto high = [](int value) { return static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U); };
    const auto low = [](int value) { return static_cast<std::uint8_t>(value); };
    return {opcode, high(right), low(right), high(left), low(left)};
  }
};

}  // namespace wheelwright::simulation
