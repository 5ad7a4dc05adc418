// A Roomba that is not there: its physics and its end of the serial protocol, on a virtual clock.
//
//   SimulatedRobot robot(config);
//   robot.receive(start_command);          // bytes leave the host now
//   robot.advance(18ms);                   // the world moves on
//   const std::size_t n = robot.transmit(buffer);   // bytes that have arrived at the host by now
//
// It starts in Off mode at rest, as if it had been switched on long ago. There are no threads, no I/O, and
// after construction no allocation. The same seed and the same calls at the same virtual times give the same
// bytes, however the time between is cut into calls of advance(). Source of the protocol: the iRobot
// documents named in open_interface_server.hpp.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "drivers/simulation/fault.hpp"
#include "drivers/simulation/recording.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "model/geometry/pose.hpp"

namespace wheelwright::simulation {

// What nobody but the simulator knows.
struct GroundTruth {
  Pose pose;           // of the middle of the axle, in the room's frame
  double v_m_s = 0.0;  // of the middle of the axle
  double w_rad_s = 0.0;
  double speed_left_m_s = 0.0;  // of the body over the floor at the left wheel; the wheel itself may slip
  double speed_right_m_s = 0.0;
  double metres_per_tick_left = 0.0;  // circumference / counts per turn
  double metres_per_tick_right = 0.0;
  double wheel_base_m = 0.0;
  double battery_voltage_v = 0.0;
  double kinetic_energy_j = 0.0;
  std::int64_t counts_left = 0;  // unwrapped, with the robot's own sign rule
  std::int64_t counts_right = 0;
  int oi_mode = 0;             // 0 Off, 1 Passive, 2 Safe, 3 Full
  bool asleep = false;         // until its Clean button is pressed
  int boots = 0;               // since it was switched on long ago
  int baud = 0;                // at which it talks and listens
  bool wheels_at_rest = true;  // both slower than 0.1 mm/s
  bool touches_wall = false;
};

class SimulatedRobot {
 public:
  explicit SimulatedRobot(const SimulationConfig& config);
  // A robot whose counters and requested speeds are those of a recording: see recording.hpp.
  SimulatedRobot(const SimulationConfig& config, Recording recording);
  SimulatedRobot(SimulatedRobot&&) noexcept;
  SimulatedRobot& operator=(SimulatedRobot&&) noexcept;
  ~SimulatedRobot();

  // Bytes leave the host now; each takes ten bits' time on the line, after those already under way.
  void receive(std::span<const std::uint8_t> from_host);
  // Moves virtual time on.
  void advance(std::chrono::nanoseconds duration);
  // Takes the bytes that have arrived at the host by now, and returns how many were written to `to_host`.
  std::size_t transmit(std::span<std::uint8_t> to_host);

  // Virtual time since construction.
  std::chrono::nanoseconds now() const;
  GroundTruth truth() const;
  void inject(const Fault& fault);
  // The speed at which the host listens and talks; where it is not the robot's own, both hear garbage. Until
  // it is called the host follows the robot.
  void set_host_baud(int baud);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace wheelwright::simulation
