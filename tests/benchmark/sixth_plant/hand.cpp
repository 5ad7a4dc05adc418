#include "tests/benchmark/sixth_plant/hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

Hand::Hand(const Robot& robot, const Pose& start, const Random& stream)
    : random(stream), robot_(robot), place_(start) {
  script_.start = start;
}

void Hand::row(double forward_m_s, double turn_rad_s) {
  const Robot& bot = robot_;
  if (ramp_s > 0) {
    const double share = bot.period_s / ramp_s;
    const double fastest_rad_s = 2 * bot.top_m_s / bot.wheel_base_m;
    forward_m_s_ += std::clamp(forward_m_s - forward_m_s_, -share * bot.top_m_s, share * bot.top_m_s);
    turn_rad_s_ += std::clamp(turn_rad_s - turn_rad_s_, -share * fastest_rad_s, share * fastest_rad_s);
  } else {
    forward_m_s_ = forward_m_s;
    turn_rad_s_ = turn_rad_s;
  }
  double left_m_s = forward_m_s_ - turn_rad_s_ * bot.wheel_base_m / 2;
  double right_m_s = forward_m_s_ + turn_rad_s_ * bot.wheel_base_m / 2;
  const double most_m_s = std::max(std::abs(left_m_s), std::abs(right_m_s));
  if (most_m_s > bot.top_m_s) {
    left_m_s *= bot.top_m_s / most_m_s;
    right_m_s *= bot.top_m_s / most_m_s;
  }
  double time_s = now_s();
  if (bot.jitters && !script_.time_s.empty())
    time_s += bot.period_s * std::clamp(0.02 * bell(random), -0.06, 0.06);
  // The robot gets what the log says.
  time_s = std::round(time_s * 1e5) / 1e5;
  left_m_s = std::round(left_m_s * 1e4) / 1e4;
  right_m_s = std::round(right_m_s * 1e4) / 1e4;
  script_.time_s.push_back(time_s);
  script_.command_m_s.push_back({left_m_s, right_m_s});
  const double moved_m_s = bot.gain * (left_m_s + right_m_s) / 2;
  const double turned_rad_s = bot.gain * (right_m_s - left_m_s) / bot.wheel_base_m;
  place_.x_m += moved_m_s * std::cos(place_.heading_rad) * bot.period_s;
  place_.y_m += moved_m_s * std::sin(place_.heading_rad) * bot.period_s;
  place_.heading_rad += turned_rad_s * bot.period_s;
}

void Hand::go(double forward_m_s, double turn_rad_s, double seconds) {
  const long rows = std::max(1L, std::lround(seconds / robot_.period_s));
  for (long count = 0; count < rows; ++count) row(forward_m_s, turn_rad_s);
}

void Hand::rest(const Range& seconds) {
  go(0, 0, drawn(seconds));
}

void Hand::go_straight(const Range& speed_share, const Range& seconds) {
  const double duration_s = drawn(seconds);
  go(drawn_m_s(speed_share), 0, duration_s);
}

void Hand::go_curved(double way, const Range& speed_share, const Range& turn_rad_s, const Range& seconds) {
  const double duration_s = drawn(seconds);
  const double turned_rad_s = drawn(turn_rad_s);
  go(way * drawn_m_s(speed_share), turned_rad_s, duration_s);
}

void Hand::spin(const Range& turn_rad_s, const Range& seconds) {
  const double duration_s = drawn(seconds);
  go(0, random.signed_uniform(turn_rad_s.low, turn_rad_s.high), duration_s);
}

void Hand::turn_by(double angle_rad, double turn_rad_s) {
  constexpr double fastest_rad_s = 3.2;
  const double rate_rad_s = std::min(turn_rad_s, fastest_rad_s);
  go(0, angle_rad > 0 ? rate_rad_s : -rate_rad_s, std::abs(angle_rad) / rate_rad_s / robot_.gain);
}

double Hand::drawn_m_s(const Range& speed_share) {
  return robot_.top_m_s * drawn(speed_share);
}

double Hand::now_s() const {
  return static_cast<double>(script_.time_s.size()) * robot_.period_s;
}

double Hand::away_m() const {
  return std::sqrt(place_.x_m * place_.x_m + place_.y_m * place_.y_m);
}

double Hand::homeward_rad() const {
  return wrapped_rad(std::atan2(-place_.y_m, -place_.x_m) - place_.heading_rad);
}

bool Hand::faces_outward() const {
  return std::abs(homeward_rad()) > std::numbers::pi / 2;
}

}  // namespace plants::sixth
