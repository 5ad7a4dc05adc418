#pragma once

#include <utility>
#include <vector>

#include "tests/benchmark/fourth_plant/programme.hpp"

namespace plants::fourth {

// Collects the commands of a run, row by row, as forward speed and turn rate.
class Script {
 public:
  Script(const DriveLimits& limits, double period_s, double duration_s)
      : limits_(limits), period_s_(period_s), duration_s_(duration_s) {}

  [[nodiscard]] bool done() const { return time_s() >= duration_s_; }
  [[nodiscard]] double time_s() const { return period_s_ * static_cast<double>(commands_.size()); }
  [[nodiscard]] double period_s() const { return period_s_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] const DriveLimits& limits() const { return limits_; }

  // One row; what the wheels cannot do is scaled down, so that the bend stays.
  void add(double forward_m_s, double turn_rad_s);
  void hold(double forward_m_s, double turn_rad_s, double for_s);
  // From what was commanded last, in a straight line.
  void ramp(double forward_m_s, double turn_rad_s, double for_s);

  [[nodiscard]] std::vector<PerWheel<double>> take() { return std::move(commands_); }

 private:
  DriveLimits limits_;
  double period_s_;
  double duration_s_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  std::vector<PerWheel<double>> commands_;
};

// The programmes; each fills the script to its end.
void write_random_steps(Script& script, Random& random);
void write_stairs(Script& script, Random& random, bool straight);
void write_stop_and_go(Script& script, Random& random);
void write_spins(Script& script, Random& random);
void write_multi_sine(Script& script, Random& random);
void write_chirp(Script& script, Random& random);
void write_laps(Script& script, Random& random);
void write_waypoints(Script& script, Random& random);

}  // namespace plants::fourth
