#pragma once

#include <deque>
#include <limits>

#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/second_plant/odd_command.hpp"

namespace plants::second {

// What the robot's firmware does to a command before the wheel controllers see it.
struct FirmwareSpec {
  double delay_s = 0.03;
  double minimum_command_m_s = 0.0;  // smaller ones switch the motor off
  double command_step_m_s = 0.0;     // integer register of the speed
  double ramp_m_s2 = std::numeric_limits<double>::infinity();
};

class Firmware {
 public:
  Firmware(const FirmwareSpec& spec, const OddCommandSpec& odd) : spec_(spec), odd_(odd) {}

  void receive(double now_s, PerWheel<double> command_m_s) {
    inbox_.push_back({now_s + spec_.delay_s, command_m_s});
  }

  // Wheel speed targets; called once per integration step.
  PerWheel<double> target_m_s(double now_s, double step_s);

 private:
  struct Packet {
    double due_s;
    PerWheel<double> command_m_s;
  };

  [[nodiscard]] double shaped(double command_m_s) const;

  FirmwareSpec spec_;
  OddCommand odd_;
  std::deque<Packet> inbox_;
  PerWheel<double> command_m_s_{};
  PerWheel<double> ramped_m_s_{};
};

}  // namespace plants::second
