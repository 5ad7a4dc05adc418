// The counter behind packets 43 and 44 (Create 2 Open Interface pages 30-31): 508.8 counts per wheel turn,
// 16 bits that wrap.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

class Encoder {
 public:
  Encoder(const EncoderConfig& config, int start_count)
      : counts_per_rad_(config.counts_per_revolution / (2.0 * std::numbers::pi)),
        sign_(config.sign),
        counter_(start_count) {}

  // The slits that have passed since the last look are counted up or down by `commanded_sign` or by
  // `motor_sign` (each -1, 0, 1; 0 counts up), or as they truly went.
  void look(double angle_rad, int commanded_sign, int motor_sign) {
    const auto slit = static_cast<std::int64_t>(std::floor(angle_rad * counts_per_rad_));
    const std::int64_t passed = slit - slit_;
    slit_ = slit;
    if (passed == 0 || frozen_) return;
    if (sign_ == EncoderSign::true_direction) {
      counter_ += passed;
      return;
    }
    const int direction = sign_ == EncoderSign::command ? commanded_sign : motor_sign;
    counter_ += direction < 0 ? -std::abs(passed) : std::abs(passed);
  }

  // As the packet holds it.
  std::int16_t reading() const { return static_cast<std::int16_t>(static_cast<std::uint64_t>(counter_)); }
  std::int64_t unwrapped() const { return counter_; }

  void add(std::int64_t counts) { counter_ += counts; }
  void freeze(bool frozen) { frozen_ = frozen; }

 private:
  double counts_per_rad_;
  EncoderSign sign_;
  std::int64_t counter_;
  std::int64_t slit_ = 0;
  bool frozen_ = false;
};

}  // namespace wheelwright::simulation
