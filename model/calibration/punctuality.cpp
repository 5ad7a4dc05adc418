#include "model/calibration/punctuality.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wheelwright {
namespace {

constexpr double late_periods = 0.5;
constexpr double largest_late_share = 0.05;

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f ms", 1e3 * seconds);
  return text;
}

}  // namespace

double Punctuality::TimingErrors::relative_error() const {
  return actions > 0 ? std::sqrt(squares) / actions : 0.0;
}

Punctuality::Punctuality(double period_s) : period_s_(period_s) {}

bool Punctuality::is_late(const SensorFrame& frame) const {
  return frame.valid && 1e-6 * frame.late_us > late_periods * period_s_;
}

void Punctuality::begin_manoeuvre() {
  *this = Punctuality(period_s_);
}

// A tick without a reading went out at some time before the next.
double Punctuality::lateness_s(const SensorFrame& frame) const {
  return frame.valid ? 1e-6 * frame.late_us : period_s_;
}

void Punctuality::take(const SensorFrame& frame) {
  if (frame.valid) {
    ++readings_;
    late_ += is_late(frame) ? 1 : 0;
    latest_s_ = std::max(latest_s_, 1e-6 * frame.late_us);
  }
  const WheelPair& command = frame.command.speed_m_s;
  if (command.left == command_m_s_.left && command.right == command_m_s_.right) return;
  end_action(frame);
  command_m_s_ = command;
  since_tick_ = frame.tick;
  began_late_by_s_ = lateness_s(frame);
}

void Punctuality::end_action(const SensorFrame& frame) {
  const double duration_s = static_cast<double>(frame.tick - since_tick_) * period_s_;
  const double error = (lateness_s(frame) - began_late_by_s_) / duration_s;
  const auto note = [&](TimingErrors& wheel) {
    wheel.squares += error * error;
    ++wheel.actions;
  };
  if (command_m_s_.left != 0.0) note(left_);
  if (command_m_s_.right != 0.0) note(right_);
}

std::optional<Refusal> Punctuality::doubt() const {
  if (late_ <= largest_late_share * readings_) return std::nullopt;
  return Refusal{
      "the machine was too busy: " + std::to_string(late_) + " of " + std::to_string(readings_) +
      " readings came more than half a period late, the latest by " + milliseconds(latest_s_) +
      "; end other programs (a browser with the live view takes part of a core), then calibrate again"};
}

std::optional<std::string> Punctuality::remark() const {
  if (late_ == 0) return std::nullopt;
  return std::to_string(late_) + " of " + std::to_string(readings_) +
         " readings came more than half a period late, the latest by " + milliseconds(latest_s_) +
         ", and were left out";
}

WheelPair Punctuality::relative_gain_error() const {
  return {left_.relative_error(), right_.relative_error()};
}

}  // namespace wheelwright
