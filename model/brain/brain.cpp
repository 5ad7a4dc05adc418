#include "model/brain/brain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelwright {
namespace {

// A stand of this length hides how long a fit took, so that the same run has the same ticks.
constexpr double shortest_wait_s = 1.0;
constexpr double shortest_coast_s = 0.7;
constexpr double longest_without_count_s = 1.0;
constexpr double longest_held_s = 1.5;

}  // namespace

Brain::Brain(const Mission& mission, const RobotLimits& limits, std::unique_ptr<DrivingModel> model)
    : mission_(mission),
      limits_(limits),
      model_(std::move(model)),
      odometry_(limits.wheel_base_m, limits.metres_per_tick),
      random_drive_(mission.random_drive.value_or(RandomDrivePlan{}), limits),
      follower_(mission.route.value_or(Route{}), follower_limits(limits)) {
  plan_steps();
}

void Brain::plan_steps() {
  const double period = limits_.period_s;
  const auto manoeuvre = [&](std::unique_ptr<Manoeuvre> what) {
    steps_.push_back({Stage::manoeuvre, std::move(what), Activity::idle});
  };
  const auto await = [&](Activity activity) { steps_.push_back({Stage::await, nullptr, activity}); };
  manoeuvre(make_wait_until_still(period));
  if (mission_.encoder_turn) {
    manoeuvre(make_encoder_check(period));
    await(Activity::await_encoder_order);
    manoeuvre(make_wait_until_still(period));
    manoeuvre(make_encoder_turn(*mission_.encoder_turn, period));
    manoeuvre(make_wait_until_still(period));
    await(Activity::await_encoder_scale);
  }
  if (mission_.response) {
    manoeuvre(make_response_actions(*mission_.response, period));
    await(Activity::await_response);
  }
  if (mission_.random_drive) {
    manoeuvre(make_wait_until_still(period));
    steps_.push_back({Stage::random_drive, nullptr, Activity::random_drive});
    await(Activity::await_arma);
  }
  if (mission_.route) {
    manoeuvre(make_wait_until_still(period));
    steps_.push_back({Stage::route, nullptr, Activity::route});
    steps_.push_back({Stage::coast, nullptr, Activity::route});
  }
  if (mission_.commanded_drive) {
    manoeuvre(make_wait_until_still(period));
    steps_.push_back({Stage::commanded_drive, make_commanded_drive(*mission_.commanded_drive, period),
                      Activity::commanded_drive});
    manoeuvre(make_wait_until_still(period));
  }
}

Brain::Stage Brain::stage() const {
  return steps_[std::min(step_, steps_.size() - 1)].stage;
}

void Brain::begin_run(std::int64_t tick) {
  running_ = true;
  stop_ = StopReason::none;
  start_tick_ = tick + 1;
  next_tick_ = std::max(next_tick_, tick + 1);
  step_ = 0;
  if (model_) model_->restart();
  rest_tick_ = next_tick_;
  odometry_.set_pose({});
  enter_step();
}

void Brain::enter_step() {
  ticks_in_stage_ = 0;
  outcome_arrived_ = false;
  if (step_ >= steps_.size()) return;
  Step& step = steps_[step_];
  if (step.manoeuvre) step.manoeuvre->restart();
  if (step.stage == Stage::random_drive) {
    random_drive_.restart(model_ != nullptr);
    stand_at(odometry_.pose());
  } else if (step.stage == Stage::route) {
    follower_.restart();
    stand_at({});
  } else if (step.stage == Stage::commanded_drive) {
    stand_at({});
  }
}

// The robot stands, and this is its pose from now on.
void Brain::stand_at(const Pose& pose) {
  odometry_.set_pose(pose);
  rest_tick_ = next_tick_;
  if (!model_) return;
  model_->rest_at(pose);
  if (model_->filter) model_->filter->set_pose(pose);
}

void Brain::advance() {
  ++step_;
  enter_step();
}

void Brain::end_by(StopReason reason) {
  running_ = false;
  stop_ = reason;
  activity_ = Activity::stopped;
}

void Brain::refuse() {
  end_by(StopReason::refused);
}

void Brain::accept_encoder_scale(const WheelPair& metres_per_tick) {
  accepted_scale_ = metres_per_tick;
  outcome_arrived_ = true;
}

void Brain::accept_model(std::unique_ptr<DrivingModel> model) {
  accepted_model_ = std::move(model);
  outcome_arrived_ = true;
}

void Brain::apply_accepted() {
  if (accepted_scale_) odometry_.correct_metres_per_tick(*accepted_scale_);
  accepted_scale_.reset();
  if (!accepted_model_) return;
  retired_model_ = std::move(model_);
  model_ = std::move(accepted_model_);
  rest_tick_ = next_tick_;
}

void Brain::exchange_model(std::unique_ptr<DrivingModel> model, std::int64_t from_tick,
                           std::uint16_t version) {
  if (exchange_.model) retired_model_ = std::move(exchange_.model);
  exchange_ = {std::move(model), from_tick, version};
}

// The predictor is as far ahead as commands were given, the filter at the frame that is to come.
void Brain::apply_exchange(std::int64_t tick) {
  if (!exchange_.model || tick < exchange_.from_tick) return;
  DrivingModel& model = *exchange_.model;
  const auto remembered = static_cast<std::int64_t>(past_commands_.size());
  for (std::int64_t past = std::max(rest_tick_, next_tick_ - remembered); past < next_tick_; ++past) {
    const auto& command = past_commands_.at(static_cast<std::size_t>(past) % past_commands_.size());
    if (command.tick != past) continue;
    model.step(command.speed_m_s);
    if (model.filter && past < tick) model.filter->prime(command.speed_m_s);
  }
  if (model_) model.take_over(*model_);
  retired_model_ = std::move(model_);
  model_ = std::move(exchange_.model);
  model_version_ = exchange_.version;
}

// What is recorded of a run, and so what a replay of it sees.
bool Brain::in_run(const SensorFrame& frame) const {
  return frame.tick >= start_tick_ && frame.command.activity != Activity::idle;
}

PoseRecord Brain::take(const SensorFrame& frame) {
  apply_exchange(frame.tick);
  const bool may_run = frame.armed && frame.stop == StopReason::none;
  if (may_run && !was_armed_) begin_run(frame.tick);
  was_armed_ = may_run;
  const bool stops = running_ && frame.stop != StopReason::none;
  if (stops) end_by(frame.stop);
  take_back_commands(frame, stops);
  if (frame.valid) {
    if (frame.after_gap) odometry_.rebase();
    const double elapsed_s = static_cast<double>(frame.tick - latest_.tick) * limits_.period_s;
    const WheelPair rolled = odometry_.update(frame.ticks);
    if (elapsed_s > 0.0) measured_speed_ = {rolled.left / elapsed_s, rolled.right / elapsed_s};
    latest_ = frame;
  } else {
    // Of a tick whose sensors were not received only the command and the time are known.
    latest_.tick = frame.tick;
    latest_.valid = false;
  }
  PoseRecord record;
  record.tick = frame.tick - start_tick_;
  record.t_s = static_cast<double>(record.tick) * limits_.period_s;
  record.command = frame.command;
  record.stop = frame.stop;
  record.odometry = odometry_.pose();
  record.measured_speed_m_s = measured_speed_;
  record.model_version = model_version_;
  record.valid = frame.valid;
  if (model_ && model_->filter && in_run(frame)) record.hybrid = model_->filter->step(frame);
  const auto slot = static_cast<std::size_t>(frame.tick) % predictions_.size();
  const Prediction& prediction = predictions_.at(slot);
  record.predicted = last_record_.predicted;
  if (prediction.tick == frame.tick) {
    record.has_prediction = true;
    record.predicted = prediction.pose;
    record.predicted_speed_m_s = prediction.speed_m_s;
    record.predicted_covariance = prediction.covariance;
    record.visited = prediction.visited;
  }
  watch_faults(record);
  last_record_ = record;
  return record;
}

void Brain::watch_faults(const PoseRecord& record) {
  const bool drives = running_ && record.hybrid.has_value();
  const auto either = [&](auto is_meant) {
    return drives && (is_meant(record.hybrid->left_fault) || is_meant(record.hybrid->right_fault));
  };
  const bool held = either([](FaultKind fault) { return fault == FaultKind::stalled; });
  const bool by_counts =
      mission_.pose_source == PoseSource::odometry && record.command.activity == Activity::route;
  const bool no_count = by_counts && either([](FaultKind fault) {
                          return fault == FaultKind::frozen || fault == FaultKind::stuck_at;
                        });
  ticks_held_ = held ? ticks_held_ + 1 : 0;
  ticks_without_count_ = no_count ? ticks_without_count_ + 1 : 0;
}

StopReason Brain::wanted_stop() const {
  if (ticks_held_ * limits_.period_s > longest_held_s) return StopReason::held;
  return ticks_without_count_ * limits_.period_s > longest_without_count_s ? StopReason::lost_count
                                                                           : StopReason::none;
}

int Brain::ticks_ahead() const {
  const bool sensorless = running_ && step_ < steps_.size() && is_sensorless_stage();
  return sensorless ? limits_.ticks_ahead : 1;
}

bool Brain::is_sensorless_stage() const {
  if (stage() == Stage::random_drive) return model_ != nullptr;
  if (stage() == Stage::commanded_drive) return true;
  const bool on_route = stage() == Stage::route || stage() == Stage::coast;
  return on_route && is_sensorless(mission_.pose_source);
}

std::optional<Command> Brain::next_command() {
  next_tick_ = std::max(next_tick_, latest_.tick + 1);
  if (next_tick_ > latest_.tick + ticks_ahead()) return std::nullopt;
  const WheelOrder wanted = order();
  Command command{next_tick_, rounded_command(wanted.speed_m_s, limits_), wanted.activity, wanted.repetition};
  remember_prediction(next_tick_, static_cast<std::uint16_t>(follower_.visited()));
  if (model_) {
    model_->save(next_tick_);
    model_->step(command.speed_m_s);
  }
  past_commands_.at(static_cast<std::size_t>(next_tick_) % past_commands_.size()) = {next_tick_,
                                                                                     command.speed_m_s};
  activity_ = command.activity;
  ++next_tick_;
  return command;
}

// Commands are made ahead, and the prediction runs ahead with them. Where another was given than that of the
// plan, and where a stop takes the place of all that were to come, it goes back and predicts once more.
void Brain::take_back_commands(const SensorFrame& frame, bool stops) {
  const auto past = [this](std::int64_t tick) -> PastCommand& {
    return past_commands_.at(static_cast<std::size_t>(tick) % past_commands_.size());
  };
  if (!model_ || frame.tick >= next_tick_ || past(frame.tick).tick != frame.tick) return;
  const WheelPair& given = frame.command.speed_m_s;
  const WheelPair& planned = past(frame.tick).speed_m_s;
  if (!stops && given.left == planned.left && given.right == planned.right) return;
  const auto back_at = model_->go_back_to(frame.tick);
  if (!back_at) return;
  past(frame.tick).speed_m_s = given;
  const std::uint16_t visited =
      predictions_.at(static_cast<std::size_t>(frame.tick) % predictions_.size()).visited;
  for (std::int64_t tick = *back_at; tick < next_tick_; ++tick) {
    if (stops && tick > frame.tick) past(tick).speed_m_s = {};
    if (tick > frame.tick) remember_prediction(tick, visited);
    model_->step(past(tick).speed_m_s);
  }
}

void Brain::remember_prediction(std::int64_t tick, std::uint16_t visited) {
  if (!model_) return;
  Prediction& slot = predictions_.at(static_cast<std::size_t>(tick) % predictions_.size());
  slot = {tick, model_->predictor.pose(), model_->predictor.speed_m_s(), Eigen::Matrix3d::Zero(), visited};
  if (model_->uncertainty) slot.covariance = model_->uncertainty->covariance();
}

WheelOrder Brain::order() {
  if (stop_ != StopReason::none) return {{}, Activity::stopped, 0};
  if (!running_) return {{}, activity_ == Activity::finished ? Activity::finished : Activity::idle, 0};
  while (step_ < steps_.size()) {
    if (const auto wanted = stage_order()) {
      ++ticks_in_stage_;
      return *wanted;
    }
    advance();
  }
  running_ = false;
  return {{}, Activity::finished, 0};
}

std::optional<WheelOrder> Brain::stage_order() {
  const Step& step = steps_[step_];
  switch (step.stage) {
    case Stage::manoeuvre:
    case Stage::commanded_drive:
      return step.manoeuvre->next(latest_);
    case Stage::await:
      return await_order(step.activity);
    case Stage::random_drive:
      return random_order();
    case Stage::route:
      return route_order();
    case Stage::coast:
      return coast_order();
  }
  return std::nullopt;
}

std::optional<WheelOrder> Brain::await_order(Activity activity) {
  const bool long_enough = ticks_in_stage_ * limits_.period_s >= shortest_wait_s;
  if (outcome_arrived_ && long_enough) {
    apply_accepted();
    return std::nullopt;
  }
  return WheelOrder{{}, activity, 0};
}

std::optional<WheelOrder> Brain::random_order() {
  const auto speed = random_drive_.next(model_ ? model_->predictor.rest_pose() : odometry_.pose());
  if (!speed) return std::nullopt;
  return WheelOrder{model_ ? model_->predictor.command_for(*speed) : *speed, Activity::random_drive, 0};
}

std::optional<WheelOrder> Brain::route_order() {
  const WheelPair speed =
      follower_.steer(steering_rest_pose(), model_ ? model_->predictor.limits() : DriveLimits{});
  if (follower_.finished()) return std::nullopt;
  const WheelPair command = model_ ? model_->predictor.command_for(speed) : speed;
  return WheelOrder{command, Activity::route, static_cast<std::uint16_t>(follower_.visited())};
}

std::optional<WheelOrder> Brain::coast_order() {
  if (ticks_in_stage_ * limits_.period_s >= shortest_coast_s) return std::nullopt;
  return WheelOrder{{}, Activity::route, static_cast<std::uint16_t>(follower_.visited())};
}

// The pose at which the robot would come to rest, by the source that steers.
Pose Brain::steering_rest_pose() {
  if (!model_) return odometry_.pose();
  if (is_sensorless(mission_.pose_source)) return model_->predictor.rest_pose();
  const bool filtered = mission_.pose_source == PoseSource::hybrid && model_->filter;
  return rest_by_sensors(filtered ? model_->filter->pose() : odometry_.pose());
}

// The sensors say where the robot was at the latest tick, the model how far it goes from there.
Pose Brain::rest_by_sensors(const Pose& measured) {
  const auto slot = static_cast<std::size_t>(latest_.tick) % predictions_.size();
  const Prediction& then = predictions_.at(slot);
  if (then.tick != latest_.tick) return measured;
  return compose(measured, between(then.pose, model_->predictor.rest_pose()));
}

}  // namespace wheelwright
