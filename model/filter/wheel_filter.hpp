// One wheel's travel from model and encoder together: a Kalman filter in the position domain with a gate.
//
// The state is by how much the wheel's travel differs from the model's. Travel, not speed, is compared: a
// lost or added count stays in the innovation until it is dealt with, while the age of a polled counter (up
// to one refresh of the robot, v * 15.6 ms) does not add up. A reading is discarded, and the model stands in
// for it,
//   * where it lies outside the gate,
//   * where the mean over one full cycle of ages lies outside a gate of its own, which is narrower since ages
//     average out in it: this catches small jumps, which stay,
//   * where the counter does not count although the wheel is to roll.
// After that the encoder has to prove itself: over a window in which the wheel was to move, its increments
// have to be those of the model. If its position fits too, nothing was lost; otherwise the encoder is given a
// new origin, and the fault's offset stays out for good.
//
// A wheel that stands proves nothing, so it stays on the model until it moves again.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace wheelwright {

struct WheelNoise {
  double refresh_period_s = 1.0 / 64.0;
  double position_noise_m = 0.0004;
  double drift_m_per_sqrt_s = 0.0003;
  double gate = 6.0;  // standard deviations of the innovation
};

// What one tick says of a wheel.
struct WheelReading {
  double predicted_m = 0.0;  // travel over this tick by the model
  double doubt_m = 0.0;      // by which that may be another, to either side
  double gain_error = 0.0;   // correction of it, as a fraction, and how sure it is
  double gain_standard_error = 0.0;
  double roughness = 1.0;  // how much more model and wheel part than the noise figures say, as a factor
  std::optional<double> counted_m;  // encoder total times metres per tick; nothing where not received
  bool doubtful = false;            // the sign of the last counts may yet change
  bool new_origin = false;          // counts have nothing to do with those before
  bool distrusted = false;          // discard whatever it says
  bool believed = false;            // the model does not hold (not driven, stalled): no gate
  bool counts_are_faulty = false;   // those so far, of an encoder that is suspended: they stay out for good
};

struct WheelEstimate {
  double step_m = 0.0;               // travel over this tick, corrections included
  double variance_growth_m2 = 0.0;   // by which the travel became less certain while the model stood in
  double innovation_m = 0.0;         // encoder minus prediction; 0 where not received
  double innovation_sd_m = 0.0;      // its standard deviation while all is sound
  double reading_sd_m = 0.0;         // of the reading alone
  double process_variance_m2 = 0.0;  // by which model and wheel may have parted over this tick, gain apart
  bool received = false;
  bool accepted = false;
  bool suspended = false;       // the model stands in until the encoder has proved itself
  bool resynchronised = false;  // it just has
  double kept_out_m = 0.0;      // with `resynchronised`: the offset that the encoder had collected
};

class WheelFilter {
 public:
  WheelFilter(const WheelNoise& noise, double period_s);

  WheelEstimate step(const WheelReading& reading);

  // The encoder is not trusted from now on, and `offset_m` that it brought into the travel is taken out.
  // Returns that offset as a step of travel.
  double suspend(double offset_m);

  // Travel against the model's since construction, in metres.
  double offset_m() const { return offset_m_; }
  double variance_m2() const { return variance_m2_; }
  bool suspended() const { return suspended_; }

 private:
  static constexpr std::size_t proof_ticks = 8;
  // Polls every 18 ms of counters that are refreshed every 15.6 ms find all ages in seven.
  static constexpr std::size_t age_cycle_ticks = 7;

  void note_doubt(const WheelReading& reading, double counted_step_m);
  bool explained_by_sign(double innovation_m, double sd_m);
  bool stands_still(const WheelReading& reading, double counted_step_m);
  void note_jump(double step_less_model_m, double predicted_m);
  bool stays_off(double innovation_m);
  void judge(const WheelReading& reading, double counted_step_m, WheelEstimate& estimate);
  double reading_variance_m2(double speed_m_s) const;
  // What a linear model errs by for a while where the speed has changed to and fro (motors that cannot
  // brake).
  double unrest_m() const;
  double mean_gate_m() const;  // of the mean over all ages
  double predict(const WheelReading& reading, double speed_m_s);
  void weigh(double innovation_m, double variance_m2);
  void discard_first();
  bool proves_sound(double counted_less_model_m, double reading_sd_m, double predicted_m);
  void resynchronise(const WheelReading& reading, WheelEstimate& estimate);
  void keep_out(WheelEstimate& estimate);

  WheelNoise noise_;
  double period_s_;
  double offset_m_ = 0.0;
  double variance_m2_ = 0.0;
  double model_m_ = 0.0;  // travel of the model
  double origin_m_ = 0.0;
  bool has_origin_ = false;
  bool suspended_ = false;
  double blind_m_ = 0.0;        // distance for which the model stood in
  double blind_doubt_m_ = 0.0;  // and the doubt over it
  double last_speed_m_s_ = 0.0;
  double recent_change_m_s_ = 0.0;  // of the speed, fading
  double unrest_m_s_ = 0.0;         // the same of its size, fading more slowly
  double doubt_m_ = 0.0;            // travel that may have been counted in the wrong direction
  int ticks_since_doubt_ = 0;
  double last_counted_m_ = 0.0;
  double since_received_m_ = 0.0;  // travel of the model since then
  std::size_t jump_matters_ticks_ = 0;
  int still_ticks_ = 0;  // in a row: no count although the wheel was to roll
  double still_m_ = 0.0;
  std::array<double, age_cycle_ticks> innovation_m_{};  // of the last readings that were used, newest first
  std::size_t innovations_ = 0;
  std::array<double, age_cycle_ticks> undone_m_{};  // corrections of the last ticks, newest first
  std::array<double, proof_ticks> residual_m_{};    // of the last readings while suspended
  std::array<double, proof_ticks> proof_step_m_{};
  std::size_t proofs_ = 0;
};

}  // namespace wheelwright
