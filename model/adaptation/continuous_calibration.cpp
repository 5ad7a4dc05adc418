#include "model/adaptation/continuous_calibration.hpp"

#include <cmath>

namespace wheelwright {
namespace {

constexpr double adapt_s = 15.0;
constexpr int judged_blocks = 8;
constexpr double driving_m_s = 0.03;

bool is_driving(const WheelPair& speed) {
  return std::abs(speed.left) > driving_m_s || std::abs(speed.right) > driving_m_s;
}

}  // namespace

ContinuousCalibration::ContinuousCalibration(const RobotModel& model) : model_(model), filter_(model) {}

void ContinuousCalibration::begin_adapting() {
  phase_ = Phase::adapt;
  adaptation_.reset();
  driven_s_ = 0.0;
}

std::optional<RobotModel> ContinuousCalibration::take(const SensorFrame& frame) {
  const HybridOutput seen = filter_.step(frame);
  const bool sound = frame.armed && seen.left_fault == FaultKind::none && seen.right_fault == FaultKind::none;
  if (phase_ == Phase::watch) {
    if (seen.recalibration_due) begin_adapting();
    return std::nullopt;
  }
  if (frame.armed && !sound) {
    begin_adapting();
    return std::nullopt;
  }
  if (phase_ == Phase::adapt) {
    if (!adaptation_) adaptation_.emplace(model_, filter_.simulation());
    adaptation_->take(frame, sound);
    if (is_driving(frame.command.speed_m_s)) driven_s_ += model_.linear_part.period_s;
    if (driven_s_ < adapt_s) return std::nullopt;
    candidate_ = adaptation_->adapted();
    trial_.emplace(model_, candidate_, filter_.simulation());
    phase_ = Phase::judge;
    return std::nullopt;
  }
  trial_->take(frame, sound);
  return trial_->blocks() < judged_blocks ? std::nullopt : decide();
}

std::optional<RobotModel> ContinuousCalibration::decide() {
  if (!trial_->is_better()) {
    begin_adapting();
    return std::nullopt;
  }
  model_ = candidate_;
  if (model_.left_fit) model_.left_fit->gain = dc_gain(model_.linear_part.left);
  if (model_.right_fit) model_.right_fit->gain = dc_gain(model_.linear_part.right);
  filter_ = HybridFilter(model_);
  phase_ = Phase::watch;
  return model_;
}

}  // namespace wheelwright
