#pragma once

#include "tests/benchmark/plants/wheels.hpp"

namespace plants::second {

// Command-side misbehaviour that is no effect of the library.
struct OddCommandSpec {
  double resend_jump_m_s = 0.0;  // after a larger jump the old command is sent again later; 0 = never
  double resend_after_s = 0.7;
  double resend_hold_s = 0.3;
  double magnet_memory_m_s = 0.0;  // hysteresis of a magnetic drive
  double low_gear_ratio = 1.0;     // every stand-still swaps between high and low gear
};

class OddCommand {
 public:
  explicit OddCommand(const OddCommandSpec& spec) : spec_(spec) {}

  PerWheel<double> apply(PerWheel<double> command_m_s, double now_s);

 private:
  PerWheel<double> resend(PerWheel<double> command_m_s, double now_s);
  double remember(std::size_t wheel, double command_m_s);
  double gear_ratio(const PerWheel<double>& command_m_s);

  OddCommandSpec spec_;
  PerWheel<double> newest_m_s_{};
  PerWheel<double> stale_m_s_{};
  double resend_from_s_ = -1.0e9;
  PerWheel<double> last_input_m_s_{};
  PerWheel<double> magnetisation_{};
  bool resting_ = true;
  bool low_gear_ = false;
};

}  // namespace plants::second
