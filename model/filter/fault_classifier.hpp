// Tells a fault of a wheel or its encoder from the others: frozen, dropped, spike, stuck, stalled. It looks
// at the readings since they stopped fitting the model, and at a few before that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/filter/fault.hpp"
#include "model/filter/wheel_evidence.hpp"

namespace wheelwright {

class FaultClassifier {
 public:
  explicit FaultClassifier(double period_s) : period_s_(period_s) {}

  // While all is well: the first readings of a fault look sound.
  void watch(const WheelEvidence& evidence);
  // A reading did not fit.
  void open();
  void take(const WheelEvidence& evidence);

  // What it is, as far as it shows by now; `misfit` while it does not.
  FaultKind name_by_now() const;
  // What it was, once the encoder has proved sound.
  FaultKind name_at_end(double kept_out_m) const;
  bool is_stall() const;

  double predicted_m() const { return predicted_m_; }
  double counted_m() const { return counted_m_; }
  double distance_m() const { return distance_m_; }

 private:
  struct Step {
    double predicted_m = 0.0;
    double counted_m = 0.0;
    double metres_per_tick = 0.0;
  };
  static constexpr std::size_t hindsight = 7;  // what a small jump needs to be seen

  void add(const Step& step);
  bool jumped() const;

  double period_s_;
  std::array<Step, hindsight> before_{};  // newest first
  int ticks_since_new_origin_ = 1 << 20;
  bool after_new_origin_ = false;
  int ticks_ = 0;
  double predicted_m_ = 0.0;
  double counted_m_ = 0.0;
  double distance_m_ = 0.0;
  double jump_m_ = 0.0;          // largest single difference between encoder and model
  double jump_counted_m_ = 0.0;  // what the encoder showed in that tick
  double jump_predicted_m_ = 0.0;
  int still_ticks_ = 0;  // in a row, without a count although the wheel was to move
  int longest_still_ticks_ = 0;
  double still_m_ = 0.0;  // the way it was to move in them
  double reading_sd_m_ = 0.0;
  double excess_a_ = 0.0;
};

}  // namespace wheelwright
