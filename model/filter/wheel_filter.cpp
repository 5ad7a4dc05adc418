#include "model/filter/wheel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/filter/wheel_evidence.hpp"

namespace wheelwright {
namespace {

// What the sign repair of a coasting wheel may leave behind, apart from the way itself, there and back.
constexpr double doubtful_sign_m = 0.001;
constexpr double longest_coast_m = 0.015;
constexpr int doubt_lasts_ticks = 14;
constexpr double sign_gate = 3.0;
// Speed changes are smeared over about so many ticks; the timing error of each is that of the whole.
constexpr double ticks_per_change = 5.0;
// A robot that brakes to rest coasts and rocks by some counts more than the noise figures of driving hold.
constexpr double min_gate_m = 0.0045;
constexpr double change_fades = 0.955;
constexpr double unrest_fades = 0.98;
// The mean over all ages of a robot that keeps its speed drifts by less than half of it.
constexpr double min_mean_gate_m = 0.003;
// Slower a wheel may stand, and a counter may wait for its next count.
constexpr double rolling_m_s = 0.03;
// A wheel that starts late stands for up to half of it.
constexpr double no_count_m = 1e-6;
constexpr int min_still_ticks = 3;
constexpr double min_still_m = 0.0045;
// The encoder has to follow the model over this distance before it is believed again ...
constexpr double min_proof_m = 0.005;
// ... within so many standard deviations of a reading. Twice the half-width of the age's uniform spread.
constexpr double proof_spread = 4.0;
// Travel that the model does not know of, per tick, where it does not hold.
constexpr double unmodelled_m = 0.01;

}  // namespace

WheelFilter::WheelFilter(const WheelNoise& noise, double period_s) : noise_(noise), period_s_(period_s) {}

// While the speed changes, the model's course of it is off by about one period of the robot's controller.
double WheelFilter::reading_variance_m2(double speed_m_s) const {
  const double age_m = std::max(std::abs(speed_m_s), std::abs(last_speed_m_s_)) * noise_.refresh_period_s;
  const double change_m = recent_change_m_s_ * noise_.refresh_period_s;
  return noise_.position_noise_m * noise_.position_noise_m + age_m * age_m / 12.0 + change_m * change_m;
}

double WheelFilter::predict(const WheelReading& reading, double speed_m_s) {
  model_m_ += reading.predicted_m;
  since_received_m_ += reading.predicted_m;
  offset_m_ += reading.gain_error * reading.predicted_m;
  const double distance_m = std::abs(reading.predicted_m);
  const double gain_m = reading.gain_standard_error * distance_m;
  const double late_m = (speed_m_s - last_speed_m_s_) * noise_.refresh_period_s;
  recent_change_m_s_ = change_fades * recent_change_m_s_ + speed_m_s - last_speed_m_s_;
  unrest_m_s_ = unrest_fades * unrest_m_s_ + std::abs(speed_m_s - last_speed_m_s_);
  const double free_m = reading.believed ? unmodelled_m : 0.0;
  const double process_m2 = noise_.drift_m_per_sqrt_s * noise_.drift_m_per_sqrt_s * period_s_ +
                            ticks_per_change * late_m * late_m / 12.0;
  const double roughness2 = reading.roughness * reading.roughness;
  // A wrong gain errs the same way all along, so its variance grows with the square of the distance, and so
  // does that of a doubt: anything from none of it to all of it, hence a third of its square.
  variance_m2_ += roughness2 * process_m2 + free_m * free_m + gain_m * gain_m +
                  2.0 * gain_m * reading.gain_standard_error * blind_m_ +
                  (reading.doubt_m * reading.doubt_m + 2.0 * reading.doubt_m * blind_doubt_m_) / 3.0;
  blind_m_ += distance_m;
  blind_doubt_m_ += reading.doubt_m;
  return process_m2;
}

// A sign can only be wrong of what was counted while the wheel turned.
void WheelFilter::note_doubt(const WheelReading& reading, double counted_step_m) {
  if (reading.doubtful) {
    const double turned_m = std::min(std::abs(counted_step_m), std::abs(since_received_m_));
    const double way_m = 2.0 * turned_m + (ticks_since_doubt_ > 0 ? doubtful_sign_m : 0.0);
    doubt_m_ = std::min(doubt_m_ + way_m, longest_coast_m);
    ticks_since_doubt_ = 0;
  } else if (++ticks_since_doubt_ > doubt_lasts_ticks) {
    doubt_m_ = 0.0;
  }
}

bool WheelFilter::stands_still(const WheelReading& reading, double counted_step_m) {
  const bool may_stand = std::abs(reading.predicted_m) < rolling_m_s * period_s_;
  const bool still = std::abs(counted_step_m) < no_count_m && !may_stand;
  still_ticks_ = still ? still_ticks_ + 1 : 0;
  still_m_ = still ? still_m_ + std::abs(since_received_m_) : 0.0;
  return still_ticks_ >= min_still_ticks && still_m_ >= min_still_m;
}

// A model errs slowly; what comes at once is not the model, nor, where no sign is in doubt, the driver's
// repair.
void WheelFilter::note_jump(double step_less_model_m, double predicted_m) {
  const double age_m = std::abs(predicted_m) / period_s_ * noise_.refresh_period_s;
  const bool jumped = doubt_m_ == 0.0 && std::abs(step_less_model_m) > age_m + min_jump_m;
  jump_matters_ticks_ = jumped ? age_cycle_ticks : std::max<std::size_t>(jump_matters_ticks_, 1) - 1;
}

double WheelFilter::unrest_m() const {
  return jump_matters_ticks_ > 0 ? 0.0 : unrest_m_s_ * noise_.refresh_period_s;
}

double WheelFilter::mean_gate_m() const {
  const double mean_sd_m =
      std::sqrt(variance_m2_ + noise_.position_noise_m * noise_.position_noise_m + unrest_m() * unrest_m());
  return std::max(min_mean_gate_m, noise_.gate * mean_sd_m);
}

bool WheelFilter::stays_off(double innovation_m) {
  std::shift_right(innovation_m_.begin(), innovation_m_.end(), 1);
  innovation_m_[0] = innovation_m;
  innovations_ = std::min(innovations_ + 1, age_cycle_ticks);
  if (innovations_ < age_cycle_ticks) return false;
  const double mean_m =
      std::accumulate(innovation_m_.begin(), innovation_m_.end(), 0.0) / static_cast<double>(age_cycle_ticks);
  return std::abs(mean_m) > mean_gate_m();
}

void WheelFilter::weigh(double innovation_m, double variance_m2) {
  const double weight = variance_m2_ / (variance_m2_ + variance_m2);
  offset_m_ += weight * innovation_m;
  variance_m2_ *= 1.0 - weight;
  blind_m_ *= 1.0 - weight;
  blind_doubt_m_ *= 1.0 - weight;
  std::shift_right(undone_m_.begin(), undone_m_.end(), 1);
  undone_m_[0] = weight * innovation_m;
}

// A fault that grows is small at first: what the last readings within the gate did is undone.
void WheelFilter::discard_first() {
  for (double& correction_m : undone_m_) {
    offset_m_ -= correction_m;
    correction_m = 0.0;
  }
  suspended_ = true;
  proofs_ = 0;
  innovations_ = 0;
}

// An encoder without direction counts a coasting wheel the wrong way. That is no fault: the model says how
// far it coasted, and the encoder's origin follows.
bool WheelFilter::explained_by_sign(double innovation_m, double sd_m) {
  const double beyond_m = std::abs(innovation_m) - sign_gate * sd_m;
  if (beyond_m <= 0.0 || beyond_m > doubt_m_) return false;
  doubt_m_ -= beyond_m;
  origin_m_ += innovation_m;
  return true;
}

double WheelFilter::suspend(double offset_m) {
  offset_m_ -= offset_m;
  suspended_ = true;
  proofs_ = 0;
  return -offset_m;
}

bool WheelFilter::proves_sound(double counted_less_model_m, double reading_sd_m, double predicted_m) {
  std::shift_right(residual_m_.begin(), residual_m_.end(), 1);
  std::shift_right(proof_step_m_.begin(), proof_step_m_.end(), 1);
  residual_m_[0] = counted_less_model_m;
  proof_step_m_[0] = predicted_m;
  proofs_ = std::min(proofs_ + 1, proof_ticks);
  if (proofs_ < proof_ticks) return false;
  double distance_m = 0.0;
  for (std::size_t i = 0; i + 1 < proof_ticks; ++i) distance_m += std::abs(proof_step_m_[i]);
  const auto [least, most] = std::minmax_element(residual_m_.begin(), residual_m_.end());
  const double allowed_m = proof_spread * reading_sd_m;
  return *most - *least <= allowed_m && distance_m >= std::max(min_proof_m, 2.0 * allowed_m);
}

void WheelFilter::resynchronise(const WheelReading& reading, WheelEstimate& estimate) {
  double mean_m = 0.0;
  for (const double residual_m : residual_m_) mean_m += residual_m / proof_ticks;
  const double found_m = mean_m - offset_m_;
  const double reading_m2 = estimate.innovation_sd_m * estimate.innovation_sd_m;
  suspended_ = false;
  undone_m_ = {};
  estimate.resynchronised = true;
  if (std::abs(found_m) <= mean_gate_m()) {
    weigh(*reading.counted_m - origin_m_ - model_m_ - offset_m_, reading_m2);
    return;
  }
  origin_m_ += found_m;
  variance_m2_ += reading_m2 / proof_ticks;
  estimate.kept_out_m = found_m;
}

// From where it stands now, whatever it counted before.
void WheelFilter::keep_out(WheelEstimate& estimate) {
  origin_m_ += estimate.innovation_m;
  estimate.kept_out_m = estimate.innovation_m;
  estimate.resynchronised = true;
  estimate.innovation_m = 0.0;
}

void WheelFilter::judge(const WheelReading& reading, double counted_step_m, WheelEstimate& estimate) {
  const double residual_m = *reading.counted_m - origin_m_ - model_m_;
  const double reading_m2 = estimate.reading_sd_m * estimate.reading_sd_m;
  estimate.innovation_m = residual_m - offset_m_;
  estimate.innovation_sd_m = std::sqrt(variance_m2_ + reading_m2);
  const double gate_m =
      std::max(min_gate_m, noise_.gate * std::hypot(estimate.innovation_sd_m, 0.5 * unrest_m()));
  const bool still = stands_still(reading, counted_step_m);
  note_doubt(reading, counted_step_m);
  note_jump(counted_step_m - since_received_m_, reading.predicted_m);
  if (reading.distrusted) {
    suspended_ = true;
  } else if (reading.believed) {
    if (suspended_ && reading.counts_are_faulty) {
      keep_out(estimate);
    } else {
      weigh(estimate.innovation_m, reading_m2);
    }
    suspended_ = false;
    estimate.accepted = true;
    undone_m_ = {};
    innovations_ = 0;
  } else if (suspended_) {
    if (proves_sound(residual_m, estimate.reading_sd_m, reading.predicted_m))
      resynchronise(reading, estimate);
  } else if (!still && explained_by_sign(estimate.innovation_m, estimate.innovation_sd_m)) {
    estimate.accepted = true;
    innovations_ = 0;
  } else if (still || std::abs(estimate.innovation_m) > gate_m || stays_off(estimate.innovation_m)) {
    discard_first();
  } else {
    estimate.accepted = true;
    weigh(estimate.innovation_m, reading_m2);
  }
}

WheelEstimate WheelFilter::step(const WheelReading& reading) {
  WheelEstimate estimate;
  const double before_m = model_m_ + offset_m_;
  const double speed_m_s = reading.predicted_m / period_s_;
  const double variance_before_m2 = variance_m2_;
  estimate.process_variance_m2 = predict(reading, speed_m_s);
  estimate.reading_sd_m = std::sqrt(reading_variance_m2(speed_m_s));
  last_speed_m_s_ = speed_m_s;
  if (reading.counted_m) {
    estimate.received = true;
    if (reading.new_origin || !has_origin_) {
      origin_m_ = *reading.counted_m - model_m_ - offset_m_;
      has_origin_ = true;
      proofs_ = 0;
      still_ticks_ = 0;
      last_counted_m_ = *reading.counted_m;
    }
    judge(reading, *reading.counted_m - last_counted_m_, estimate);
    last_counted_m_ = *reading.counted_m;
    since_received_m_ = 0.0;
  }
  estimate.suspended = suspended_;
  estimate.step_m = model_m_ + offset_m_ - before_m;
  estimate.variance_growth_m2 = estimate.accepted ? 0.0 : std::max(0.0, variance_m2_ - variance_before_m2);
  return estimate;
}

}  // namespace wheelwright
