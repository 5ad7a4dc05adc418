#pragma once

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/plants/wheels.hpp"

namespace plants::third {

// Forces on the wheels that are no effect of the library.
struct OddForceSpec {
  double gust_n = 0.0;  // wind that pushes and turns the robot now and then
  double hum_n = 0.0;   // arm that swings and pushes both wheels
  double hum_hz = 1.0;
  double load_share = 0.0;  // hanging load that swings between stops, relative to the mass that a motor moves
  double load_hz = 1.5;
};

class OddForce {
 public:
  OddForce(const OddForceSpec& spec, double rim_mass_kg, Random random);

  // `motor_m_s` is the mean of both wheels.
  void step(double now_s, double motor_m_s, double step_s);

  [[nodiscard]] double on_wheel_n(std::size_t wheel, double wheel_m_s, double now_s) const;

 private:
  void step_gusts(double now_s, double step_s);
  void step_load(double motor_m_s, double step_s);
  [[nodiscard]] double gust_n(std::size_t wheel, double wheel_m_s) const;
  [[nodiscard]] double stop_m_s2() const;

  OddForceSpec spec_;
  double rim_mass_kg_;
  Random random_;
  double hum_phase_rad_;
  bool blowing_ = false;
  double blowing_until_s_ = 0.0;
  double push_ = 0.0;  // of unit variance, as is the turning one
  double turning_ = 0.0;
  double load_m_ = 0.0;
  double load_m_s_ = 0.0;
  double motor_before_m_s_ = 0.0;
};

}  // namespace plants::third
