#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/second_plant/friction.hpp"

namespace plants::second {

// Forces on the robot that are no effect of the library.
struct OddForceSpec {
  double pump_n = 0.0;  // pulsing pump that loads both drives, bound to time
  double pump_period_s = 0.9;
  double gust_n = 0.0;  // fan that blows across the room now and then
  double gust_period_s = 9.0;
  double gust_direction_rad = 0.0;
  double seizing_drag_n_s_m = 0.0;  // one wheel jams for a moment
  double seizing_every_s = 8.0;
  double payload_kg = 0.0;  // load on a tray that breaks loose and swings on a spring
  double payload_hz = 2.0;
  FrictionSpec payload_friction{};
};

class OddForce {
 public:
  OddForce(const OddForceSpec& spec, Random random);

  void step(double now_s, double acceleration_m_s2, double step_s);

  [[nodiscard]] double pump_n(double now_s) const;
  [[nodiscard]] double gust_n(double now_s, double heading_rad) const;
  [[nodiscard]] double payload_n() const { return payload_n_; }
  [[nodiscard]] double seizing_n(std::size_t wheel, double now_s, double wheel_m_s) const;

 private:
  void step_payload(double acceleration_m_s2, double step_s);

  OddForceSpec spec_;
  Random random_;
  Friction payload_friction_;
  double pump_phase_s_;
  double gust_phase_s_;
  double next_seizing_s_ = 1.0e9;
  double seizing_until_s_ = -1.0;
  std::size_t seizing_wheel_ = left_side;
  double payload_m_ = 0.0;
  double payload_m_s_ = 0.0;
  double payload_n_ = 0.0;
};

}  // namespace plants::second
