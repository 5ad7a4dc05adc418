#pragma once

#include <deque>

#include "tests/benchmark/plants/wheels.hpp"

namespace plants::third {

enum class Rounding { nearest, towards_zero };

// What happens to a command between the wire and the wheel controllers. Zero: does not happen.
struct FirmwareSpec {
  double delay_s = 0.02;
  double command_step_m_s = 0.0;  // integer arithmetic
  Rounding rounding = Rounding::nearest;
  double dead_band_m_s = 0.0;       // smaller commands are dropped
  bool dead_band_rescales = false;  // what lies above it begins at zero again
  double ramp_m_s2 = 0.0;
  double full_scale_m_s = 0.35;
  PerWheel<double> gain{1.0, 1.0};  // two wheels are never quite alike
};

class Firmware {
 public:
  explicit Firmware(const FirmwareSpec& spec) : spec_(spec) {}

  void receive(double now_s, const PerWheel<double>& command_m_s) {
    on_the_way_.push_back({now_s + spec_.delay_s, command_m_s});
  }

  // What the wheel controllers are asked for; called once per integration step.
  PerWheel<double> target_m_s(double now_s, double step_s);

 private:
  struct Packet {
    double due_s;
    PerWheel<double> command_m_s;
  };

  [[nodiscard]] double whole_steps_m_s(double command_m_s) const;
  [[nodiscard]] double above_dead_band_m_s(double command_m_s) const;
  double ramped_m_s(std::size_t wheel, double command_m_s, double step_s);

  FirmwareSpec spec_;
  std::deque<Packet> on_the_way_;
  PerWheel<double> command_m_s_{};
  PerWheel<double> ramp_m_s_{};
};

}  // namespace plants::third
