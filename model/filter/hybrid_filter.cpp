#include "model/filter/hybrid_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/simulation/known_scale.hpp"

namespace wheelwright {
namespace {

// After so many ticks without news the last command has long settled or was stopped.
constexpr std::int64_t max_ticks_left_out = 200;
// While the robot did not obey, its wheels may have done anything; the model forgets it within this time.
constexpr std::int64_t believed_after_rest_ticks = 45;

// For so long after a wheel stood or turned round the sign of its counts can be wrong; the frame does not say
// of which wheel it is.
constexpr std::int64_t turn_matters_ticks = 30;

// Bits of packet 14.
constexpr unsigned right_overcurrent = 8U;
constexpr unsigned left_overcurrent = 16U;
// A link takes so long to see that a counter's jump is lasting; after a longer silence it was the link.
constexpr std::int64_t longest_jump_ticks = 8;

WheelNoise wheel_noise(const FilterNoise& noise, double position_noise_m, double drift_m_per_sqrt_s) {
  WheelNoise wheel;
  wheel.refresh_period_s = noise.refresh_period_s;
  wheel.position_noise_m = position_noise_m;
  wheel.drift_m_per_sqrt_s = drift_m_per_sqrt_s;
  return wheel;
}

}  // namespace

HybridFilter::HybridFilter(const RobotModel& model)
    : HybridFilter(model.linear_part, known_scale(model), filter_noise_of(model), effect_settings(model)) {
  doubt_ = ModelDoubt(model);
}

HybridFilter::HybridFilter(const LinearModel& model, const WheelPair& metres_per_tick,
                           const FilterNoise& noise, std::span<const EffectSetting> effects)
    : period_s_(model.period_s),
      noise_(noise),
      wheel_base_m_(model.wheel_base_m),
      simulation_(model, effects),
      left_(wheel_noise(noise, noise.position_noise_m.left, noise.drift_m_per_sqrt_s.left), model.period_s,
            metres_per_tick.left, noise.gain_standard_error.left),
      right_(wheel_noise(noise, noise.position_noise_m.right, noise.drift_m_per_sqrt_s.right), model.period_s,
             metres_per_tick.right, noise.gain_standard_error.right),
      detector_(model.period_s),
      environment_(model.period_s),
      misfit_(model.period_s),
      pose_(model.wheel_base_m, {noise.scale_standard_error, noise.wheel_mismatch}) {}

void HybridFilter::prime(const WheelPair& command_m_s) {
  const double battery_v = std::numeric_limits<double>::quiet_NaN();
  doubt_.step(command_m_s, battery_v, simulation_.step(command_m_s, battery_v).wheel_m_s);
}

void HybridFilter::set_prediction(Side& side, double predicted_m, double ticks) const {
  side.predicted_m = predicted_m;
  const double speed_m_s = ticks > 0.0 ? predicted_m / (ticks * period_s_) : side.speed_m_s;
  side.acceleration_m_s2 = ticks > 0.0 ? (speed_m_s - side.speed_m_s) / (ticks * period_s_) : 0.0;
  side.speed_m_s = speed_m_s;
}

void HybridFilter::advance_model(const SensorFrame& frame) {
  constexpr double unknown_v = std::numeric_limits<double>::quiet_NaN();
  const double battery_v = frame.battery_v > 0.0 ? frame.battery_v : unknown_v;
  WheelPair predicted_m;
  beyond_wheels_ = {};
  simulation_.set_pose(pose_.pose());
  simulation_.set_distance_m(rolled_m_);
  doubt_.set_place(pose_.pose(), rolled_m_);
  left_.doubt_m = right_.doubt_m = 0.0;
  const std::int64_t ticks =
      started_ ? std::clamp<std::int64_t>(frame.tick - tick_, 0, max_ticks_left_out) : 0;
  for (std::int64_t i = 0; i < ticks; ++i) {
    const auto& motion = simulation_.step(command_, battery_v);
    const WheelPair& speed = motion.wheel_m_s;
    const Twist by_wheels = twist_of_wheels(speed, wheel_base_m_);
    const WheelPair doubt = doubt_.step(command_, battery_v, speed);
    predicted_m.left += period_s_ * speed.left;
    predicted_m.right += period_s_ * speed.right;
    left_.doubt_m += period_s_ * doubt.left;
    right_.doubt_m += period_s_ * doubt.right;
    beyond_wheels_.v_m_s += period_s_ * (motion.twist.v_m_s - by_wheels.v_m_s);
    beyond_wheels_.w_rad_s += period_s_ * (motion.twist.w_rad_s - by_wheels.w_rad_s);
  }
  set_prediction(left_, predicted_m.left, static_cast<double>(ticks));
  set_prediction(right_, predicted_m.right, static_cast<double>(ticks));
  watch_turn(left_, command_.left, frame.tick);
  watch_turn(right_, command_.right, frame.tick);
  if (!started_) last_not_driven_tick_ = frame.tick;  // nobody knows what was before
  started_ = true;
  tick_ = frame.tick;
  command_ = frame.command.speed_m_s;
}

void HybridFilter::watch_turn(Side& side, double command_m_s, std::int64_t tick) {
  constexpr double turning_m_s = 0.003;
  // The wheel still turns against the direction in which a robot without quadrature counts by now.
  const bool turns = std::abs(side.speed_m_s) > turning_m_s;
  side.counts_backwards = turns && (command_m_s < 0.0) != (side.speed_m_s < 0.0);
  if (!turns || side.counts_backwards) side.turned_tick = tick;
}

void HybridFilter::step_wheel(Side& side, const SensorFrame& frame, std::int64_t ticks) {
  WheelReading reading;
  reading.predicted_m = side.predicted_m;
  reading.doubt_m = side.doubt_m;
  reading.gain_error = side.drift.gain_error();
  reading.gain_standard_error = side.drift.gain_standard_error();
  reading.roughness = side.drift.roughness();
  const bool turned = frame.tick - side.turned_tick < turn_matters_ticks;
  reading.doubtful = side.counts_backwards || (frame.doubtful_sign && turned);
  reading.new_origin = frame.after_gap;
  reading.believed =
      frame.tick - last_not_driven_tick_ < believed_after_rest_ticks || side.stalled || model_is_off_;
  // Where both wheels leave the model, what looked like faulty counts was the model.
  reading.counts_are_faulty =
      !model_is_off_ && is_of_encoder(detector_.fault(&side == &right_ ? WheelSide::right : WheelSide::left));
  reading.distrusted = side.distrusted && !model_is_off_;
  if (frame.valid) reading.counted_m = side.metres_per_tick * static_cast<double>(ticks);
  const WheelEstimate estimate = side.filter.step(reading);
  side.step_m = estimate.step_m + side.taken_out_m;
  side.taken_out_m = 0.0;
  side.variance_m2 = noise_.slip_m_per_sqrt_m * noise_.slip_m_per_sqrt_m * std::abs(side.predicted_m) +
                     estimate.variance_growth_m2;
  gather(side, reading, estimate);
  if (!estimate.accepted || reading.believed || estimate.resynchronised) {
    side.drift.interrupt();
  } else {
    side.drift.take(side.predicted_m, side.doubt_m, side.filter.offset_m(), estimate.process_variance_m2,
                    estimate.reading_sd_m);
  }
  side.out.speed_m_s = (1.0 + side.drift.gain_error()) * side.speed_m_s;
  side.out.innovation_m = estimate.innovation_m;
  side.out.innovation = estimate.received ? estimate.innovation_m / estimate.innovation_sd_m : 0.0;
  side.out.accepted = estimate.accepted;
  side.out.discarded = estimate.received && !estimate.accepted;
}

void HybridFilter::gather(Side& side, const WheelReading& reading, const WheelEstimate& estimate) {
  WheelEvidence& evidence = side.evidence;
  evidence = {};
  side.predicted_since_received_m += side.predicted_m;
  evidence.metres_per_tick = side.metres_per_tick;
  evidence.innovation_m = estimate.innovation_m;
  evidence.reading_sd_m = estimate.reading_sd_m;
  evidence.new_origin = reading.new_origin && estimate.received;
  evidence.accepted = estimate.accepted;
  evidence.suspended = estimate.suspended;
  evidence.resynchronised = estimate.resynchronised;
  evidence.kept_out_m = estimate.kept_out_m;
  if (!estimate.received) return;
  evidence.received = side.was_received && !reading.new_origin;
  evidence.predicted_m = side.predicted_since_received_m;
  evidence.counted_m = *reading.counted_m - side.counted_m;
  side.predicted_since_received_m = 0.0;
  side.counted_m = *reading.counted_m;
  side.was_received = true;
}

void HybridFilter::obey(Side& side, bool stalled, bool distrusted, double take_out_m) {
  if (take_out_m != 0.0) side.taken_out_m = side.filter.suspend(take_out_m);
  side.stalled = stalled;
  side.distrusted = distrusted;
}

bool HybridFilter::is_in_doubt(const Side& side) {
  constexpr double share = 0.01;  // of the travel: less is far from what a misfit of the gain is
  return side.doubt_m > share * std::abs(side.predicted_m);
}

bool HybridFilter::watch_gain(const SensorFrame& frame) {
  const bool settled = frame.tick - last_not_driven_tick_ >= believed_after_rest_ticks;
  if (!frame.armed || !settled || detector_.any()) {
    misfit_.restart();
  } else if (!left_.evidence.received || !right_.evidence.received || frame.doubtful_sign ||
             left_.counts_backwards || right_.counts_backwards || is_in_doubt(left_) || is_in_doubt(right_)) {
    misfit_.drop_block();
  } else {
    misfit_.take({left_.evidence.predicted_m, right_.evidence.predicted_m},
                 {left_.evidence.counted_m, right_.evidence.counted_m});
  }
  return misfit_.found();
}

bool HybridFilter::watch_environment(const SensorFrame& frame, bool both_misfit) {
  DrivingEvidence evidence;
  evidence.received = frame.valid;
  evidence.sound = frame.armed && !detector_.any();
  evidence.speed_m_s = {left_.speed_m_s, right_.speed_m_s};
  evidence.acceleration_m_s2 = {left_.acceleration_m_s2, right_.acceleration_m_s2};
  evidence.heading_rad = pose_.pose().theta_rad;
  evidence.current_a = frame.motor_current_a;
  evidence.innovation = {left_.out.innovation, right_.out.innovation};
  evidence.both_misfit = both_misfit;
  return environment_.take(evidence);
}

void HybridFilter::judge(const SensorFrame& frame, HybridOutput& output) {
  TickEvidence evidence;
  evidence.tick = frame.tick;
  evidence.wheels = {left_.evidence, right_.evidence};
  evidence.wheels[0].excess_a = environment_.excess_a().left;
  evidence.wheels[1].excess_a = environment_.excess_a().right;
  evidence.drift_statistic = {left_.drift.statistic(), right_.drift.statistic()};
  evidence.whole_drift_statistic = {left_.drift.whole_statistic(), right_.drift.whole_statistic()};
  evidence.drift_collected_m = {left_.drift.collected_m(), right_.drift.collected_m()};
  evidence.overcurrent = {frame.valid && (frame.overcurrents & left_overcurrent) != 0,
                          frame.valid && (frame.overcurrents & right_overcurrent) != 0};
  const bool short_silence = received_ && frame.tick - last_received_tick_ <= longest_jump_ticks;
  evidence.counter_jumped = frame.valid && frame.after_gap && short_silence;
  if (frame.valid) {
    received_ = true;
    last_received_tick_ = frame.tick;
  }
  evidence.driven = frame.armed && !model_is_off_;
  evidence.wheel_drop = frame.valid && frame.wheel_drop;
  const FaultVerdict verdict = detector_.take(evidence, output.events);
  obey(left_, verdict.stalled[0], verdict.distrust[0], verdict.take_out_m[0]);
  obey(right_, verdict.stalled[1], verdict.distrust[1], verdict.take_out_m[1]);
  if (verdict.exchange) {
    exchanged_ = !exchanged_;
    left_.was_received = right_.was_received = false;
  }
  model_is_off_ = model_is_off_ || verdict.model_is_off;
  const bool other_gain = watch_gain(frame);
  output.raised_recalibration = watch_environment(frame, verdict.model_is_off || other_gain);
  output.recalibration_due = environment_.recalibration_due();
  output.left_fault = detector_.fault(WheelSide::left);
  output.right_fault = detector_.fault(WheelSide::right);
}

HybridOutput HybridFilter::step(const SensorFrame& frame) {
  HybridOutput output;
  output.tick = frame.tick;
  advance_model(frame);
  if (!frame.armed) last_not_driven_tick_ = frame.tick;
  step_wheel(left_, frame, exchanged_ ? frame.ticks.right : frame.ticks.left);
  step_wheel(right_, frame, exchanged_ ? frame.ticks.left : frame.ticks.right);
  judge(frame, output);
  output.left = left_.out;
  output.right = right_.out;
  const bool stalled = left_.stalled || right_.stalled;
  rolled_m_ = {rolled_m_.left + left_.step_m, rolled_m_.right + right_.step_m};
  pose_.move({left_.step_m, right_.step_m}, {left_.variance_m2, right_.variance_m2},
             stalled ? Twist{} : beyond_wheels_);
  output.pose = pose_.pose();
  output.covariance = pose_.covariance();
  return output;
}

}  // namespace wheelwright
