#include "model/brain/calibrator.hpp"

#include "model/brain/route_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>

#include "model/log/sign_corrected_travel.hpp"

namespace wheelwright {
namespace {

constexpr std::int64_t min_check_ticks = 20;  // of the some 100 that the check makes a wheel turn

bool is_response(Activity activity) {
  return activity == Activity::left_on || activity == Activity::left_off || activity == Activity::right_on ||
         activity == Activity::right_off;
}

// An exchange of models comes this long after it was found, so that the time that the machine took to make
// the model does not show in what is driven.
constexpr double exchange_delay_s = 0.5;

// What the model is held against: the route, and standing before it, from when on the brain drives by the
// model.
bool is_watched(Activity activity) {
  return activity == Activity::wait_until_still || activity == Activity::route;
}

bool is_rest(Activity activity) {
  return activity == Activity::idle || activity == Activity::finished || activity == Activity::stopped;
}

constexpr int max_refused_counts = 5;  // by chance, of a manoeuvre
constexpr std::size_t settling_samples = 20;

constexpr std::size_t longest_response = 40;  // periods

// A wheel whose speed controller counts whole ticks may crawl on long after it was told to stop, a tick at a
// time, where grease is thick. No linear response of this length does that, and one that is fitted to it
// takes the way crawled for gain. Of such a run only the start is used.
void leave_out_crawl(DriveLog& run) {
  auto& samples = run.samples;
  const auto off = std::find_if(samples.begin(), samples.end(), [](const DriveSample& sample) {
    return sample.command_m_s.left == 0.0 && sample.command_m_s.right == 0.0;
  });
  const auto first_off = static_cast<std::size_t>(off - samples.begin());
  std::size_t last_moving = first_off;
  for (std::size_t k = first_off + 1; k < samples.size(); ++k) {
    const auto& now = samples[k].ticks;
    const auto& before = samples[k - 1].ticks;
    if (now && before && (now->left != before->left || now->right != before->right)) last_moving = k;
  }
  if (last_moving - first_off > longest_response) samples.resize(first_off);
}

// A wheel's gain is known no better than how long the command was in force that made it.
void widen(const DcGain& gain, double relative_error, DcGain& standard_error) {
  standard_error.from_left = std::hypot(standard_error.from_left, gain.from_left * relative_error);
  standard_error.from_right = std::hypot(standard_error.from_right, gain.from_right * relative_error);
}

// Too few readings may be left because some came late.
Refusal with_remark(const Refusal& refusal, const std::optional<std::string>& remark) {
  return remark ? Refusal{refusal.reason + "; " + *remark} : refusal;
}

}  // namespace

Calibrator::Calibrator(const Mission& mission, const RobotLimits& limits,
                       const std::optional<RobotModel>& model)
    : mission_(mission),
      limits_(limits),
      metres_per_tick_(limits.metres_per_tick),
      punctuality_(limits.period_s) {
  watch(model);
}

void Calibrator::watch(const std::optional<RobotModel>& model) {
  continuous_.reset();
  if (mission_.adapt && mission_.route && model && model->encoder_scale) continuous_.emplace(*model);
}

std::optional<CalibrationOutcome> Calibrator::take(const SensorFrame& frame) {
  const Activity before = last_activity_;
  last_activity_ = frame.command.activity;
  auto outcome = take_manoeuvre(frame, last_activity_ != before);
  if (!outcome) return adapt(frame, before);
  if (outcome->model) watch(outcome->model);
  const bool last = outcome->kind == CalibrationKind::arma || !mission_.random_drive;
  if (outcome->model && last) outcome->route_refusal = doubt_of_route(*outcome->model, mission_, limits_);
  return outcome;
}

std::optional<CalibrationOutcome> Calibrator::adapt(const SensorFrame& frame, Activity before) {
  if (!continuous_ || !is_watched(frame.command.activity)) return std::nullopt;
  // A new run, before which the robot may have been carried elsewhere.
  if (is_rest(before)) watch(RobotModel(continuous_->model()));
  auto model = continuous_->take(frame);
  if (!model) return std::nullopt;
  CalibrationOutcome outcome;
  outcome.kind = CalibrationKind::adaptation;
  outcome.adapted = AdaptedModel{frame.tick, frame.tick + std::llround(exchange_delay_s / limits_.period_s),
                                 ++model_version_, continuous_->trial()->present_error_m().value_or(0.0),
                                 continuous_->trial()->candidate_error_m().value_or(0.0)};
  outcome.model = std::move(model);
  return outcome;
}

std::optional<CalibrationOutcome> Calibrator::take_manoeuvre(const SensorFrame& frame, bool entered) {
  const Activity activity = frame.command.activity;
  if (activity == Activity::encoder_check) {
    if (entered) check_start_.reset();
    // Only the forward part counts: at command zero a robot without quadrature counts up in any case.
    if (frame.valid && frame.command.repetition == 0) {
      if (!check_start_) check_start_ = frame.ticks;
      check_end_ = frame.ticks;
    }
  } else if (activity == Activity::encoder_turn) {
    if (entered) turn_samples_.clear();
    // The counters may have been exchanged a moment ago.
    if (frame.after_gap && turn_samples_.size() < settling_samples) turn_samples_.clear();
    note_counts(frame, entered, !turn_samples_.empty());
    if (frame.valid) turn_samples_.push_back({frame.ticks, frame.light_bumper});
  } else if (is_response(activity)) {
    const bool begins = entered && activity == Activity::left_on && frame.command.repetition == 0;
    if (begins) {
      response_runs_.clear();
      response_counts_.clear();
    }
    note_counts(frame, begins, !response_runs_.empty());
    record_response(frame);
  } else if (activity == Activity::random_drive) {
    if (entered) begin_random(frame);
    note_counts(frame, entered, !random_run_.samples.empty());
    record_random(frame);
  } else if (entered) {
    if (activity == Activity::await_encoder_order) return encoder_order();
    if (activity == Activity::await_encoder_scale) return encoder_scale();
    if (activity == Activity::await_response) return response();
    if (activity == Activity::await_arma) return arma();
  }
  return std::nullopt;
}

void Calibrator::note_counts(const SensorFrame& frame, bool entered, bool recorded_before) {
  if (entered) {
    refused_counts_ = 0;
    counts_broke_ = false;
    punctuality_.begin_manoeuvre();
  }
  punctuality_.take(frame);
  // Only a reading has a battery voltage.
  if (!frame.valid && frame.battery_v > 0.0) ++refused_counts_;
  counts_broke_ = counts_broke_ || (frame.valid && frame.after_gap && recorded_before);
}

// Who loses ticks on the way finds a scale that is wrong by more than the spread of its parts shows.
std::optional<Refusal> Calibrator::doubt_of_counts() const {
  if (refused_counts_ > max_refused_counts) {
    return Refusal{
        std::to_string(refused_counts_) +
        " readings hold encoder counts that no wheel can have made; the serial adapter or the cable "
        "damages bytes: see wheelwright doctor, then calibrate again"};
  }
  if (counts_broke_) {
    return Refusal{"the encoder counts jumped on the way; look at cable and encoders, calibrate again"};
  }
  return std::nullopt;
}

// A turn in place needs no such doubt of time: its counts and what the bumper saw come in one reply.
std::optional<Refusal> Calibrator::doubt_of_manoeuvre() const {
  const auto doubt = doubt_of_counts();
  return doubt ? doubt : punctuality_.doubt();
}

namespace {

std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

// Motors are a few percent apart, encoders less. A wheel that shows far less than the other had a counter
// that did not count for a part of the calibration, or it was held.
std::optional<Refusal> doubt_of_gains(double left, double right) {
  constexpr double most_apart = 1.5;
  if (left > 0.0 && right > 0.0 && left < most_apart * right && right < most_apart * left)
    return std::nullopt;
  const bool is_left = left < right;
  return Refusal{"the " + std::string(is_left ? "left" : "right") + " wheel counted " +
                 percent(is_left ? left : right) + " of what it was told to drive, the other " +
                 percent(is_left ? right : left) +
                 "; look whether it turns freely and its encoder counts: wheelwright doctor --move"};
}

}  // namespace

CalibrationOutcome Calibrator::encoder_order() const {
  CalibrationOutcome outcome;
  outcome.kind = CalibrationKind::encoder_order;
  if (!check_start_) {
    outcome.refusal = Refusal{"no sound sensor reading came while the left wheel was driven"};
    return outcome;
  }
  const auto left = std::abs(check_end_.left - check_start_->left);
  const auto right = std::abs(check_end_.right - check_start_->right);
  if (left < min_check_ticks && right < min_check_ticks) {
    outcome.refusal = Refusal{
        "no counter moved while the left wheel was told to turn; do both wheels stand on the floor, and do "
        "the encoders count (wheelwright doctor --move)?"};
  } else if (2 * std::min(left, right) > std::max(left, right)) {
    outcome.refusal =
        Refusal{"the left wheel was commanded to move, and both counters did; is the robot being pushed?"};
  } else {
    outcome.encoders_swapped = right > left;
  }
  return outcome;
}

CalibrationOutcome Calibrator::encoder_scale() {
  CalibrationOutcome outcome;
  outcome.kind = CalibrationKind::encoder_scale;
  outcome.refusal = doubt_of_counts();
  if (outcome.refusal) return outcome;
  auto fit = fit_encoder_scale(turn_samples_, mission_.encoder_turn->options);
  if (fit) {
    metres_per_tick_ = fit->metres_per_tick;
    encoder_scale_ = EncoderScale{fit->metres_per_tick, fit->ticks_per_turn, fit->relative_standard_error};
    outcome.encoder_scale = std::move(*fit);
  } else {
    outcome.refusal = fit.error();
  }
  return outcome;
}

DriveLog Calibrator::new_run(std::string name) const {
  DriveLog run;
  run.name = std::move(name);
  run.wheel_base_m = limits_.wheel_base_m;
  run.period_s = limits_.period_s;
  run.metres_per_tick = metres_per_tick_;
  return run;
}

// One run per "on" with the "off" that follows it. Each starts from rest, so its past is known. Where the
// fall is not to be used, the run ends with the "on".
void Calibrator::record_response(const SensorFrame& frame) {
  const Activity activity = frame.command.activity;
  const bool on = activity == Activity::left_on || activity == Activity::right_on;
  const WheelPair& command = frame.command.speed_m_s;
  const bool begins = on && (response_runs_.empty() || response_runs_.back().samples.empty() ||
                             response_runs_.back().samples.back().command_m_s.left != command.left ||
                             response_runs_.back().samples.back().command_m_s.right != command.right);
  if (begins) {
    response_runs_.push_back(new_run("response action " + std::to_string(response_runs_.size() + 1)));
    response_counts_.emplace_back();
  }
  const bool usable = frame.valid && !punctuality_.is_late(frame);
  if (response_runs_.empty() || !usable || (!on && !mission_.response->use_fall)) return;
  DriveSample sample;
  // Counted from the action's own start, so that a replay of the log fits the very same numbers.
  if (response_runs_.back().samples.empty()) response_start_tick_ = frame.tick;
  sample.t_s = static_cast<double>(frame.tick - response_start_tick_) * limits_.period_s;
  sample.command_m_s = command;
  sample.ticks = frame.ticks;
  sample.battery_v = frame.battery_v;
  response_runs_.back().samples.push_back(sample);
  response_counts_.back().push_back(frame.counted_ticks);
}

CalibrationOutcome Calibrator::response() const {
  CalibrationOutcome outcome;
  outcome.kind = CalibrationKind::response;
  outcome.refusal = doubt_of_manoeuvre();
  if (outcome.refusal) return outcome;
  outcome.remark = punctuality_.remark();
  std::vector<DriveLog> runs = response_runs_;
  settle_travel(runs, response_counts_);
  std::erase_if(runs, [](const DriveLog& run) { return run.samples.empty(); });
  for (DriveLog& run : runs) leave_out_crawl(run);
  const FirFitOptions options{
      .first_bound = longest_response, .longest = longest_response, .period_s = limits_.period_s};
  auto fit = fit_fir(runs, options);
  if (fit) outcome.refusal = doubt_of_gains(fit->left.gain.from_left, fit->right.gain.from_right);
  if (outcome.refusal) return outcome;
  if (fit) {
    const WheelPair timing = punctuality_.relative_gain_error();
    widen(fit->left.gain, timing.left, fit->left.gain_standard_error);
    widen(fit->right.gain, timing.right, fit->right.gain_standard_error);
    outcome.model =
        model_of(fit->model, fit->left, fit->right,
                 "response calibration on the robot, " + std::to_string(response_runs_.size()) + " actions");
    outcome.response = std::move(*fit);
  } else {
    outcome.refusal = with_remark(fit.error(), outcome.remark);
  }
  return outcome;
}

void Calibrator::begin_random(const SensorFrame& frame) {
  random_run_ = new_run("random drive");
  random_counts_.clear();
  random_start_tick_ = frame.tick;
}

// Ticks whose sensors were not received are kept for their commands; the run begins at rest, with a reading.
void Calibrator::record_random(const SensorFrame& frame) {
  const bool usable = frame.valid && !punctuality_.is_late(frame);
  if (random_run_.samples.empty() && !usable) return;
  DriveSample sample;
  sample.t_s = static_cast<double>(frame.tick - random_start_tick_) * limits_.period_s;
  sample.command_m_s = frame.command.speed_m_s;
  if (usable) {
    sample.ticks = frame.ticks;
    sample.battery_v = frame.battery_v;
  }
  random_run_.samples.push_back(sample);
  random_counts_.push_back(frame.counted_ticks);
}

CalibrationOutcome Calibrator::arma() const {
  CalibrationOutcome outcome;
  outcome.kind = CalibrationKind::arma;
  outcome.refusal = doubt_of_manoeuvre();
  if (outcome.refusal) return outcome;
  outcome.remark = punctuality_.remark();
  ArmaFitOptions options;
  options.order = mission_.random_drive->order;
  options.period_s = limits_.period_s;
  DriveLog run = random_run_;
  settle_travel(std::span(&run, 1), std::span(&random_counts_, 1));
  auto fit = fit_arma(std::span(&run, 1), options);
  if (!fit) {
    outcome.refusal = with_remark(fit.error(), outcome.remark);
    return outcome;
  }
  outcome.refusal = doubt_of_gains(fit->left.quality.gain.from_left, fit->right.quality.gain.from_right);
  if (outcome.refusal) return outcome;
  outcome.model = model_of(fit->model, fit->left.quality, fit->right.quality,
                           "random drive on the robot, seed " + std::to_string(mission_.random_drive->seed));
  outcome.arma = std::move(*fit);
  return outcome;
}

RobotModel Calibrator::model_of(const LinearModel& linear_part, const WheelFit& left, const WheelFit& right,
                                std::string source) const {
  RobotModel model;
  model.source = {std::move(source)};
  model.encoder_scale = encoder_scale_;
  model.linear_part = linear_part;
  model.left_fit = left;
  model.right_fit = right;
  return model;
}

}  // namespace wheelwright
