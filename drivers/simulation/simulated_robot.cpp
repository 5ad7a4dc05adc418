#include "drivers/simulation/simulated_robot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "drivers/simulation/mechanics.hpp"
#include "drivers/simulation/open_interface_server.hpp"
#include "drivers/simulation/sensor_board.hpp"
#include "drivers/simulation/serial_line.hpp"

namespace wheelwright::simulation {
namespace {

constexpr std::size_t uart_buffer_bytes = 256;
constexpr double at_rest_m_s = 1e-4;

double metres_per_tick(const WheelConfig& wheel, const EncoderConfig& encoder) {
  return std::numbers::pi * wheel.diameter_m / encoder.counts_per_revolution;
}

}  // namespace

struct SimulatedRobot::Parts {
  explicit Parts(const SimulationConfig& robot)
      : config(robot),
        noise(robot.seed),
        line_noise(robot.seed ^ 0x5eed0f11e5ULL),
        mechanics(robot, noise),
        sensors(robot),
        from_host(SerialLine::Sender::host, robot.link.baud, SerialLine::capacity, robot.link.to_robot,
                  robot.link.latency_to_robot_s),
        to_host(SerialLine::Sender::robot, robot.link.baud, uart_buffer_bytes, robot.link.to_host, 0.0),
        receiver(robot.link.usb_latency_timer_s, robot.link.usb_chunk_bytes),
        server(robot, mechanics, sensors, from_host, to_host, line_noise),
        step(nanoseconds(robot.physics_step_s)),
        tick(nanoseconds(robot.firmware.tick_s)),
        sensor_period(nanoseconds(robot.firmware.sensor_update_period_s)),
        next_tick(tick),
        next_refresh(sensor_period) {
    refresh_sensors(Nanoseconds::zero());
  }

  Nanoseconds next_event() const { return std::min({physics_time + step, next_tick, next_refresh}); }
  void run_to(Nanoseconds event);
  void refresh_sensors(Nanoseconds at);
  void receive(const SerialLine::Arrival& arrival);

  SimulationConfig config;
  Noise noise;
  Noise line_noise;  // apart, so that what is asked does not change what is measured
  Mechanics mechanics;
  SensorBoard sensors;
  SerialLine from_host;
  SerialLine to_host;
  Receiver receiver;
  OpenInterfaceServer server;
  Nanoseconds step;
  Nanoseconds tick;
  Nanoseconds sensor_period;
  Nanoseconds next_tick;
  Nanoseconds next_refresh;
  Nanoseconds physics_time{0};
  Nanoseconds now{0};
  std::optional<Player> player;  // where the robot answers with a recording
};

void SimulatedRobot::Parts::run_to(Nanoseconds event) {
  mechanics.step(1e-9 * static_cast<double>((event - physics_time).count()));
  physics_time = event;
  if (event == next_tick) {
    mechanics.controller_tick();
    next_tick += tick;
  }
  if (event == next_refresh) {
    refresh_sensors(event);
    server.sensor_tick(event);
    next_refresh += sensor_period;
  }
}

void SimulatedRobot::Parts::refresh_sensors(Nanoseconds at) {
  sensors.refresh(mechanics, server.charger_connected(), noise);
  if (player) player->answer(sensors, at);
}

void SimulatedRobot::Parts::receive(const SerialLine::Arrival& arrival) {
  const bool obeyed = server.receive(arrival.byte, arrival.at);
  if (!player || !obeyed) return;
  player->drive_commanded(arrival.at);
  player->answer(sensors, arrival.at);
}

SimulatedRobot::SimulatedRobot(const SimulationConfig& config) : parts_(std::make_unique<Parts>(config)) {}
SimulatedRobot::SimulatedRobot(const SimulationConfig& config, Recording recording) : SimulatedRobot(config) {
  parts_->player.emplace(std::move(recording));
  parts_->refresh_sensors(Nanoseconds::zero());
}
SimulatedRobot::SimulatedRobot(SimulatedRobot&&) noexcept = default;
SimulatedRobot& SimulatedRobot::operator=(SimulatedRobot&&) noexcept = default;
SimulatedRobot::~SimulatedRobot() = default;

void SimulatedRobot::receive(std::span<const std::uint8_t> from_host) {
  for (const std::uint8_t byte : from_host) parts_->from_host.send(byte, parts_->now, parts_->line_noise);
}

void SimulatedRobot::advance(std::chrono::nanoseconds duration) {
  Parts& p = *parts_;
  const Nanoseconds end = p.now + duration;
  while (true) {
    const Nanoseconds event = p.next_event();
    const auto byte = p.from_host.front();
    if (byte && byte->at <= std::min(event, end)) {
      p.from_host.pop();
      p.receive(*byte);
    } else if (event <= end) {
      p.run_to(event);
    } else {
      break;
    }
  }
  p.now = end;
}

std::size_t SimulatedRobot::transmit(std::span<std::uint8_t> to_host) {
  const std::size_t count = std::min(to_host.size(), parts_->receiver.readable(parts_->to_host, parts_->now));
  for (std::size_t i = 0; i < count; ++i) {
    to_host[i] = parts_->to_host.at(0).byte;
    parts_->to_host.pop();
  }
  parts_->receiver.taken(count);
  return count;
}

void SimulatedRobot::set_host_baud(int baud) {
  parts_->from_host.set_host_baud(baud);
  parts_->to_host.set_host_baud(baud);
}

std::chrono::nanoseconds SimulatedRobot::now() const {
  return parts_->now;
}

GroundTruth SimulatedRobot::truth() const {
  const Parts& p = *parts_;
  const Chassis& body = p.mechanics.chassis();
  const auto still = [](const DriveSide& side) {
    return std::abs(side.unit.speed_rad_s()) * side.unit.rolling_radius_m() < at_rest_m_s;
  };
  return {.pose = body.pose_after(1e-9 * static_cast<double>((p.now - p.physics_time).count())),
          .v_m_s = body.forward_speed_m_s(),
          .w_rad_s = body.turn_rate_rad_s(),
          .speed_left_m_s = body.left_speed_m_s(),
          .speed_right_m_s = body.right_speed_m_s(),
          .metres_per_tick_left = metres_per_tick(p.config.left, p.config.encoder),
          .metres_per_tick_right = metres_per_tick(p.config.right, p.config.encoder),
          .wheel_base_m = p.config.chassis.wheel_base_m,
          .battery_voltage_v = p.mechanics.battery().voltage_v(),
          .kinetic_energy_j = p.mechanics.kinetic_energy_j(),
          .counts_left = p.mechanics.left().encoder.unwrapped(),
          .counts_right = p.mechanics.right().encoder.unwrapped(),
          .oi_mode = static_cast<int>(p.server.mode()),
          .asleep = p.server.asleep(),
          .boots = p.server.boots(),
          .baud = p.to_host.baud(),
          .wheels_at_rest = still(p.mechanics.left()) && still(p.mechanics.right()),
          .touches_wall = body.touches()};
}

void SimulatedRobot::inject(const Fault& fault) {
  Parts& p = *parts_;
  switch (fault.kind) {
    case Fault::Kind::plug_charger:
    case Fault::Kind::unplug_charger:
      return p.server.plug_charger(fault.kind == Fault::Kind::plug_charger);
    case Fault::Kind::power_off:
      p.to_host.clear(p.now);
      p.receiver.reset();
      return p.server.power_off();
    case Fault::Kind::power_on:
      return p.server.power_on(p.now);
    case Fault::Kind::press_clean:
      return p.server.wake(p.now);
    default:
      return p.mechanics.inject(fault);
  }
}

}  // namespace wheelwright::simulation
