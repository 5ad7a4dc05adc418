#include "model/log/sensor_frame.hpp"

namespace wheelwright {

std::string_view name_of(Activity activity) {
  switch (activity) {
    case Activity::idle:
      return "idle";
    case Activity::wait_until_still:
      return "wait_until_still";
    case Activity::encoder_check:
      return "encoder_check";
    case Activity::await_encoder_order:
      return "await_encoder_order";
    case Activity::encoder_turn:
      return "encoder_turn";
    case Activity::await_encoder_scale:
      return "await_encoder_scale";
    case Activity::left_on:
      return "left_on";
    case Activity::left_off:
      return "left_off";
    case Activity::right_on:
      return "right_on";
    case Activity::right_off:
      return "right_off";
    case Activity::await_response:
      return "await_response";
    case Activity::random_drive:
      return "random_drive";
    case Activity::await_arma:
      return "await_arma";
    case Activity::route:
      return "route";
    case Activity::commanded_drive:
      return "commanded_drive";
    case Activity::finished:
      return "finished";
    case Activity::stopped:
      return "stopped";
  }
  return "unknown";
}

std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::none:
      return "none";
    case StopReason::bump:
      return "bump";
    case StopReason::cliff:
      return "cliff";
    case StopReason::wheel_drop:
      return "wheel drop";
    case StopReason::overcurrent:
      return "motor overcurrent";
    case StopReason::mode_changed:
      return "robot left the driving mode";
    case StopReason::low_battery:
      return "low battery";
    case StopReason::charging:
      return "robot is charging";
    case StopReason::blind:
      return "no valid sensor reading for too long";
    case StopReason::link_lost:
      return "link lost";
    case StopReason::late_command:
      return "no command in time";
    case StopReason::stalled:
      return "sensor loop stood still";
    case StopReason::refused:
      return "calibration refused";
    case StopReason::requested:
      return "requested";
    case StopReason::held:
      return "a wheel is held though its motor pulls";
    case StopReason::lost_count:
      return "an encoder that steers the route counts no more";
    case StopReason::other_period:
      return "the robot streams at another period than link.period_s";
  }
  return "unknown";
}

}  // namespace wheelwright
