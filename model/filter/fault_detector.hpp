// Finds faults of wheels and encoders, tells them apart and names them.
//
// Tests, each per wheel and each sequential. The rates of false alarms are those of normal noise, at 55.6
// readings/s of both wheels:
//   * gate on the travel innovation, 6 standard deviations but at least 4.5 mm: 8e-4 an hour; finds what
//     happens at once (spike, freeze, stuck, stall, swap, lost counts),
//   * gate on its mean over seven readings, 6 standard deviations but at least 3 mm; finds small jumps,
//   * no count over 4.5 mm that the wheel was to roll; finds counts that are lost for a moment,
//   * generalised likelihood ratio over windows up to 16 s (scale_drift_detector.hpp), 7 standard deviations,
//   63
//     windows four times a second: below 1e-4 an hour; finds what creeps.
// What a linear model cannot know (motors that cannot brake) is not normal: both gates widen after changes of
// speed, but where a reading jumps. Jumps of less than about 1 cm may stay unseen then, of 4 mm at steady
// speed. So do they where a model with effects is in doubt (model_doubt.hpp), and by the roughness that was
// learnt of a wheel. A name follows once it can be told: FaultClassifier decides it.
//
// Limits. Frozen and stuck differ by the jump; a counter that sticks within a few counts of where it was is
// called frozen. Swapped encoders show, and matter, only while the wheels are told to turn differently. A
// drift of both encoders alike is taken for a change of the environment, and so is a load on both wheels.
// Slip: the encoders turn with the wheels, so wheels that spin on a smooth floor, or both slip alike, are not
// seen at all; only a robot that is held while its wheels spin shows, by current. A hanging wheel is seen by
// its wheel-drop switch; the frame does not say which wheel, so it is said of both.
#pragma once

#include <array>
#include <cstdint>

#include "model/filter/fault.hpp"
#include "model/filter/fault_classifier.hpp"
#include "model/filter/wheel_evidence.hpp"
#include "model/geometry/wheel_side.hpp"

namespace wheelwright {

struct TickEvidence {
  std::int64_t tick = 0;
  std::array<WheelEvidence, 2> wheels;      // left, right
  std::array<double, 2> drift_statistic{};  // of scale_drift_detector.hpp: steady, and with steps of any size
  std::array<double, 2> whole_drift_statistic{};
  std::array<double, 2> drift_collected_m{};
  bool driven = false;  // the robot obeys
  bool wheel_drop = false;
  std::array<bool, 2> overcurrent{};
  bool counter_jumped = false;  // the link gave the counts a new origin although the robot was received
};

// What the filter is to do about it.
struct FaultVerdict {
  std::array<bool, 2> stalled{};       // believe the encoder, not the model
  std::array<bool, 2> distrust{};      // discard the encoder until further notice
  std::array<double, 2> take_out_m{};  // offset that a drift brought into the travel
  bool exchange = false;               // left and right counts, from now on
  bool model_is_off = false;  // both wheels leave the model: believe the encoders until it is made again
};

class FaultDetector {
 public:
  explicit FaultDetector(double period_s);

  FaultVerdict take(const TickEvidence& evidence, FaultEvents& events);

  // Of the fault that lasts on a wheel; `none` where there is none.
  FaultKind fault(WheelSide wheel) const { return sides_[wheel == WheelSide::right ? 1 : 0].kind; }
  bool any() const { return sides_[0].kind != FaultKind::none || sides_[1].kind != FaultKind::none; }

 private:
  struct Side {
    explicit Side(double period_s) : classifier(period_s) {}
    FaultKind kind = FaultKind::none;
    FaultClassifier classifier;
    double recent_misfits = 0.0;  // fading
    bool overcurrent = false;
    double turned_m = 0.0;  // while stalled: what it turned, and what the model predicts, fading
    double predicted_m = 0.0;
    double held_s = 0.0;  // of high current although the wheel turns
  };

  void look_for_misfit(std::size_t wheel, const TickEvidence& evidence, FaultEvents& events);
  bool are_swapped(const TickEvidence& evidence) const;
  void look_for_drift(const TickEvidence& evidence, FaultVerdict& verdict, FaultEvents& events);
  void look_for_stall_end(std::size_t wheel, const TickEvidence& evidence, FaultEvents& events);
  bool both_misfit(const TickEvidence& evidence);
  void end_drifts(const TickEvidence& evidence, FaultEvents& events);
  void look_for_slip(const TickEvidence& evidence, FaultEvents& events);
  void look_for_overcurrent(const TickEvidence& evidence, FaultEvents& events);
  void look_for_lift(const TickEvidence& evidence, FaultEvents& events);

  double period_s_;
  std::array<Side, 2> sides_;
  double both_open_s_ = 0.0;
  bool slips_ = false;
  double held_s_ = 0.0;
  bool lifted_ = false;
};

}  // namespace wheelwright
